#include "geometry/surface_sample.h"

#include "geometry/disc_point.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

/// The volume of the unit cube's image.
double volume_scale(const Transform& to_world) {
  const dvec3 x = to_world.vector({1.0, 0.0, 0.0});
  const dvec3 y = to_world.vector({0.0, 1.0, 0.0});
  const dvec3 z = to_world.vector({0.0, 0.0, 1.0});
  return std::abs(glm::dot(x, glm::cross(y, z)));
}

/// World area per local area where the world normal is `normal` (unit): an affine map M takes an
/// element of area with local normal m to det(M) M^-T m, whose length this is. M^T normal is
/// parallel to m.
double area_scale(const Transform& to_world, const dvec3& normal) {
  const dvec3 columns{glm::dot(to_world.vector({1.0, 0.0, 0.0}), normal),
                      glm::dot(to_world.vector({0.0, 1.0, 0.0}), normal),
                      glm::dot(to_world.vector({0.0, 0.0, 1.0}), normal)};
  return volume_scale(to_world) / glm::length(columns);
}

/// A point in the shape's own frame.
struct LocalSample {
  dvec3 point, normal;
  int face;
};

LocalSample local_sample(const Square&, const dvec2& u) {
  return {{2.0 * u.x - 1.0, 2.0 * u.y - 1.0, 0.0}, {0.0, 0.0, 1.0}, 0};
}
double local_area(const Square&) {
  return 4.0;
}

LocalSample local_sample(const Disc&, const dvec2& u) {
  return {dvec3(disc_point(u), 0.0), {0.0, 0.0, 1.0}, 0};
}
double local_area(const Disc&) {
  return kPi;
}

/// Area on a sphere is proportional to height.
LocalSample local_sample(const Sphere&, const dvec2& u) {
  const double z = 1.0 - 2.0 * u.x;
  const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
  const dvec3 p(r * circle_point(u.y), z);
  return {p, p, 0};
}
double local_area(const Sphere&) {
  return 4.0 * kPi;
}

LocalSample local_sample(const Box&, const dvec2& u) {
  const double x = 6.0 * u.x;
  const int face = std::min(static_cast<int>(x), 5);
  const int axis = face / 2;
  LocalSample sample{dvec3(0.0), dvec3(0.0), face};
  sample.normal[axis] = face % 2 == 0 ? -1.0 : 1.0;
  sample.point[axis] = sample.normal[axis];
  sample.point[(axis + 1) % 3] = 2.0 * (x - face) - 1.0;
  sample.point[(axis + 2) % 3] = 2.0 * u.y - 1.0;
  return sample;
}
double local_area(const Box&) {
  return 24.0;
}

template <class S>
concept Sampled = requires(const S& shape) {
  local_area(shape);
};

} // namespace

bool has_sampled_points(const Shape& shape) {
  return std::visit([]<class S>(const S&) { return Sampled<S>; }, shape);
}

std::optional<SurfaceSample> sample_surface(const PlacedShape& placed, const dvec2& u) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::optional<SurfaceSample> {
        if constexpr (Sampled<S>) {
          const LocalSample local = local_sample(shape, u);
          SurfaceSample sample;
          sample.point = placed.to_world.point(local.point);
          sample.normal = placed.to_world.normal(local.normal);
          sample.face = {0, local.face};
          sample.density = 1.0 / (local_area(shape) * area_scale(placed.to_world, sample.normal));
          return sample;
        } else {
          return std::nullopt;
        }
      },
      placed.shape);
}

double surface_density(const PlacedShape& placed, const dvec3& normal) {
  return std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (Sampled<S>)
          return 1.0 / (local_area(shape) * area_scale(placed.to_world, normal));
        else
          return 0.0;
      },
      placed.shape);
}

double surface_area(const PlacedShape& placed) {
  // By the rule of midpoints over the two numbers; exact where the map is a similarity or the
  // shape's faces are flat.
  constexpr int kSteps = 48;
  double area = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j)
      if (const auto s = sample_surface(placed, {(i + 0.5) / kSteps, (j + 0.5) / kSteps}))
        area += 1.0 / s->density;
  return area / (kSteps * kSteps);
}

} // namespace abbe
