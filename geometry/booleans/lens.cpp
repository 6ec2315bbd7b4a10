#include "geometry/booleans/lens.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

/// Half of the chord that a ball has at this height above its middle.
double half_chord(double radius, double height) {
  return std::sqrt((std::abs(radius) - height) * (std::abs(radius) + height));
}

/// Where the cylinder ends at a surface, seen from its vertex in the direction out of the glass.
/// `radius` is above 0 where the surface is concave, its ball outside. The cylinder must reach
/// beyond a curved surface, but not beyond the middle of a ball that is taken away.
double overshoot(double radius, double height) {
  if (radius == 0.0) return 0.0;
  if (radius < 0.0) return height;
  return sag(radius, height) + std::min(height, 0.5 * half_chord(radius, height));
}

/// A ball that must leave the glass of a convex surface holds it up to the far edge and vertex.
bool covers(double radius, double height, double thickness, double far_edge) {
  return thickness <= 2.0 * radius && far_edge <= radius + half_chord(radius, height);
}

void check(const LensElement& lens, double height) {
  for (const double radius : {lens.front_radius, lens.back_radius})
    if (radius != 0.0 && std::abs(radius) < height)
      throw std::invalid_argument("a radius of curvature is less than half of the diameter");
  const double front = sag(lens.front_radius, height), back = sag(lens.back_radius, height);
  if (lens.thickness + back - front < 0.0)
    throw std::invalid_argument("its surfaces cross inside the diameter");
  const bool front_covers =
      lens.front_radius <= 0.0 ||
      covers(lens.front_radius, height, lens.thickness, lens.thickness + back);
  const bool back_covers =
      lens.back_radius >= 0.0 ||
      covers(-lens.back_radius, height, lens.thickness, lens.thickness - front);
  if (!front_covers || !back_covers)
    throw std::invalid_argument("it is thicker than the ball that a convex surface belongs to");
}

/// The glass that remains at a surface. `bulge` is above 0 where it is convex.
CsgTree ground(CsgTree glass, double radius, double bulge, double vertex, MaterialId material) {
  if (radius == 0.0) return glass;
  const Transform ball = Transform::translation({0.0, 0.0, vertex + radius})
                             .after(Transform::scaling(dvec3(std::abs(radius))));
  return {bulge > 0.0 ? CsgOperation::intersect : CsgOperation::subtract, std::move(glass),
          CsgTree(Sphere{}, ball, material)};
}

} // namespace

double sag(double radius, double height) {
  if (radius == 0.0) return 0.0;
  const double sine = height / radius;
  return height * sine / (1.0 + std::sqrt(1.0 - sine * sine));
}

CsgTree lens_element(const LensElement& lens, MaterialId material) {
  const double height = 0.5 * lens.diameter;
  check(lens, height);
  const double begin = lens.front_vertex - overshoot(-lens.front_radius, height);
  const double end = lens.back_vertex() + overshoot(lens.back_radius, height);
  const Transform place = Transform::translation({0.0, 0.0, begin})
                              .after(Transform::scaling({height, height, end - begin}));
  CsgTree glass(TaperedCylinder{1.0}, place, material);
  glass =
      ground(std::move(glass), lens.front_radius, lens.front_radius, lens.front_vertex, material);
  return ground(std::move(glass), lens.back_radius, -lens.back_radius, lens.back_vertex(),
                material);
}

} // namespace abbe
