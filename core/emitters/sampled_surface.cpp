#include "core/emitters/sampled_surface.h"

#include "core/emitters/cone.h"
#include "geometry/solids/polyhedron_faces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

// A map that stretches by less than this, relatively, is a similarity: a chain of rotations in
// double rounds a few 2^-53. Rays to such a ball end a little before it, by far more than that.
constexpr double kSimilar = 0x1p-48, kShortOfBall = 0x1p-40;

/// Turns a pdf per area into one per steradian: an area A at distance d fills A cos / d^2.
std::optional<SeenPoint> seen_from(const dvec3& place, const dvec3& point, const dvec3& normal,
                                   double per_area, bool both_sides) {
  const dvec3 way = point - place;
  const double distance2 = glm::dot(way, way);
  if (!(distance2 > 0.0)) return std::nullopt;
  const double distance = std::sqrt(distance2);
  const dvec3 direction = way / distance;
  const double facing = -glm::dot(direction, normal);
  const double cosine = both_sides ? std::abs(facing) : facing;
  if (!(cosine > 0.0)) return std::nullopt;
  return SeenPoint{direction, distance, per_area * distance2 / cosine};
}

double per_steradian(const dvec3& place, const dvec3& point, const dvec3& normal, double per_area) {
  const dvec3 way = point - place;
  const double distance2 = glm::dot(way, way);
  const double cosine = std::abs(glm::dot(way, normal)) / std::sqrt(distance2);
  return cosine > 0.0 ? per_area * distance2 / cosine : 0.0;
}

std::array<dvec3, 3> columns(const Transform& t) {
  return {t.vector({1.0, 0.0, 0.0}), t.vector({0.0, 1.0, 0.0}), t.vector({0.0, 0.0, 1.0})};
}

double signed_volume(const Transform& t) {
  const auto [x, y, z] = columns(t);
  return glm::dot(x, glm::cross(y, z));
}

bool is_similarity(const Transform& t) {
  const auto [x, y, z] = columns(t);
  const double xx = glm::dot(x, x);
  for (const double zero :
       {glm::dot(y, y) - xx, glm::dot(z, z) - xx, glm::dot(x, y), glm::dot(y, z), glm::dot(z, x)})
    if (std::abs(zero) > kSimilar * xx) return false;
  return true;
}

// What each shape becomes; shapes without such a function cannot be sampled.

SampledSurface surface_of(const Square&, const Transform& t, bool both_sides) {
  const auto [x, y, z] = columns(t);
  return FlatSurface{
      t.point({-1.0, -1.0, 0.0}),          2.0 * x, 2.0 * y,   t.normal({0.0, 0.0, 1.0}),
      4.0 * glm::length(glm::cross(x, y)), false,   both_sides};
}

SampledSurface surface_of(const Disc&, const Transform& t, bool both_sides) {
  const auto [x, y, z] = columns(t);
  return FlatSurface{t.point(dvec3(0.0)),
                     x,
                     y,
                     t.normal({0.0, 0.0, 1.0}),
                     pi * glm::length(glm::cross(x, y)),
                     true,
                     both_sides};
}

SampledSurface surface_of(const Sphere&, const Transform& t, bool) {
  if (is_similarity(t)) return BallSurface{t.point(dvec3(0.0)), glm::length(columns(t)[0])};
  return EllipsoidSurface{t, std::abs(signed_volume(t))};
}

SampledSurface surface_of(const Box&, const Transform& t, bool) {
  BoxSurface box{t.point(dvec3(0.0)), columns(t), {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    dvec3 axis(0.0);
    axis[static_cast<int>(i)] = 1.0;
    box.normal[i] = t.normal(axis);
    box.height[i] = glm::dot(box.half[i], box.normal[i]);
    box.face_area[i] = 4.0 * glm::length(glm::cross(box.half[(i + 1) % 3], box.half[(i + 2) % 3]));
  }
  return box;
}

SampledSurface surface_of(const ConvexPolyhedron& solid, const Transform& t, bool) {
  PolyhedronSurface surface{{}, 0.0};
  const int faces = static_cast<int>(solid.half_spaces().size());
  for (int face = 0; face < faces; ++face) {
    const std::vector<dvec3> corners = face_corners(solid, face);
    const dvec3 normal = t.normal(solid.half_spaces()[static_cast<std::size_t>(face)].normal);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const TriangleEdges edges{t.point(corners[0]), t.vector(corners[i - 1] - corners[0]),
                                t.vector(corners[i] - corners[0])};
      const double area = 0.5 * glm::length(glm::cross(edges.ab, edges.ac));
      surface.parts.push_back({edges, normal, area, face});
      surface.whole_area += area;
    }
  }
  return surface;
}

SampledSurface surface_of(const Mesh& mesh, const Transform& t, bool both_sides) {
  MeshSurface surface{&mesh, t, {}, signed_volume(t) < 0.0, both_sides && !mesh.is_closed()};
  double sum = 0.0;
  for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i) {
    const TriangleEdges edges = surface.triangle(i);
    sum += 0.5 * glm::length(glm::cross(edges.ab, edges.ac));
    surface.cumulative.push_back(sum);
  }
  return surface;
}

bool turns_to(const PolyhedronSurface::Part& part, const dvec3& place) {
  return glm::dot(place - part.triangle.corner, part.normal) > 0.0;
}

template <class S>
concept Sampled = requires(const S& shape) { surface_of(shape, Transform(), false); };

} // namespace

std::optional<SampledSurface> sampled_surface(const PlacedShape& placed, bool both_sides) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::optional<SampledSurface> {
        if constexpr (Sampled<S>)
          return surface_of(shape, placed.to_world, both_sides);
        else
          return std::nullopt;
      },
      placed.shape);
}

bool can_sample_surface(const Shape& shape) {
  return std::visit([]<class S>(const S&) { return Sampled<S>; }, shape);
}

std::optional<SeenPoint> FlatSurface::sample(const dvec3& place, const dvec2& u) const {
  const dvec2 p = disc ? disc_point(u) : u;
  return seen_from(place, origin + p.x * x + p.y * y, normal, 1.0 / size, both_sides);
}

double FlatSurface::pdf(const dvec3& place, const dvec3& point, const dvec3& n) const {
  return per_steradian(place, point, n, 1.0 / size);
}

std::optional<SeenPoint> BallSurface::sample(const dvec3& place, const dvec2& u) const {
  const dvec3 way = centre - place;
  const double d = glm::length(way);
  if (!(d > radius)) return std::nullopt;
  const Cone cone = Cone::of_sine(way / d, radius * radius / (d * d));
  const dvec3 direction = cone.sample(u);
  const double along = glm::dot(way, direction);
  // The ray passes the centre at this squared distance; as a cross product it does not cancel.
  const dvec3 beside = glm::cross(way, direction);
  const double half_chord2 = radius * radius - glm::dot(beside, beside);
  const double distance = along - std::sqrt(std::max(0.0, half_chord2));
  return SeenPoint{direction, std::max(0.0, distance - kShortOfBall * d), cone.pdf()};
}

double BallSurface::pdf(const dvec3& place, const dvec3&, const dvec3&) const {
  const dvec3 way = centre - place;
  const double d = glm::length(way);
  return d > radius ? Cone::of_sine(way / d, radius * radius / (d * d)).pdf() : 0.0;
}

double BallSurface::area() const {
  return 4.0 * pi * radius * radius;
}

std::optional<SeenPoint> EllipsoidSurface::sample(const dvec3& place, const dvec2& u) const {
  const dvec3 local = sphere_point(u);
  const dvec3 normal = to_world.normal(local);
  return seen_from(place, to_world.point(local), normal, area_pdf(normal), false);
}

double EllipsoidSurface::pdf(const dvec3& place, const dvec3& point, const dvec3& n) const {
  return per_steradian(place, point, n, area_pdf(n));
}

/// An affine map M takes an element of area with normal m to det(M) M^-T m, whose length is the
/// world area per local area; M^T normal is parallel to m.
double EllipsoidSurface::area_pdf(const dvec3& normal) const {
  const auto [x, y, z] = columns(to_world);
  const dvec3 back{glm::dot(x, normal), glm::dot(y, normal), glm::dot(z, normal)};
  return glm::length(back) / (4.0 * pi * volume_scale);
}

double EllipsoidSurface::area() const {
  constexpr int kSteps = 48;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double z = (2.0 * i + 1.0) / kSteps - 1.0, angle = 2.0 * pi * (j + 0.5) / kSteps;
      const double r = std::sqrt(1.0 - z * z);
      sum += 1.0 / area_pdf(to_world.normal({r * std::cos(angle), r * std::sin(angle), z}));
    }
  return sum / (kSteps * kSteps);
}

std::array<int, 3> BoxSurface::seen(const dvec3& place) const {
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double above = glm::dot(place - centre, normal[i]);
    sides[i] = above > height[i] ? 1 : above < -height[i] ? -1 : 0;
  }
  return sides;
}

double BoxSurface::seen_area(const std::array<int, 3>& sides) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (sides[i] != 0) sum += face_area[i];
  return sum;
}

std::optional<SeenPoint> BoxSurface::sample(const dvec3& place, const dvec2& u) const {
  const std::array<int, 3> sides = seen(place);
  const double total = seen_area(sides);
  if (!(total > 0.0)) return std::nullopt;
  // The first number chooses the face and is stretched to [0, 1) again.
  double rest = u.x * total;
  std::size_t face = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] == 0) continue;
    face = i;
    if (rest < face_area[i]) break;
    rest -= face_area[i];
  }
  const double x = std::min(rest / face_area[face], 1.0);
  const double side = sides[face];
  const dvec3 point = centre + side * half[face] + (2.0 * x - 1.0) * half[(face + 1) % 3] +
                      (2.0 * u.y - 1.0) * half[(face + 2) % 3];
  return seen_from(place, point, side * normal[face], 1.0 / total, false);
}

double BoxSurface::pdf(const dvec3& place, const dvec3& point, const dvec3& n) const {
  const double total = seen_area(seen(place));
  return total > 0.0 ? per_steradian(place, point, n, 1.0 / total) : 0.0;
}

double BoxSurface::area() const {
  return 2.0 * (face_area[0] + face_area[1] + face_area[2]);
}

std::optional<SeenPoint> PolyhedronSurface::sample(const dvec3& place, const dvec2& u) const {
  const double total = seen_area(place);
  double rest = u.x * total;
  const Part* chosen = nullptr;
  for (const Part& part : parts) {
    if (!turns_to(part, place)) continue;
    chosen = &part;
    if (rest < part.area) break;
    rest -= part.area;
  }
  if (!chosen) return std::nullopt;
  const dvec3 point = triangle_point(chosen->triangle, std::min(rest / chosen->area, 1.0), u.y);
  return seen_from(place, point, chosen->normal, 1.0 / total, false);
}

double PolyhedronSurface::pdf(const dvec3& place, const dvec3& point, const dvec3& n) const {
  const double total = seen_area(place);
  return total > 0.0 ? per_steradian(place, point, n, 1.0 / total) : 0.0;
}

double PolyhedronSurface::seen_area(const dvec3& place) const {
  double sum = 0.0;
  for (const Part& part : parts)
    if (turns_to(part, place)) sum += part.area;
  return sum;
}

std::optional<SeenPoint> MeshSurface::sample(const dvec3& place, const dvec2& u) const {
  double x = u.x;
  const TriangleEdges chosen = triangle(choose(x));
  return seen_from(place, triangle_point(chosen, x, u.y), normal(chosen), 1.0 / area(), both_sides);
}

double MeshSurface::pdf(const dvec3& place, const dvec3& point, const dvec3& n) const {
  return per_steradian(place, point, n, 1.0 / area());
}

} // namespace abbe
