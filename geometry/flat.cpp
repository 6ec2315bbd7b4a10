#include "geometry/flat.h"

#include <cmath>

namespace abbe {

bool covers(const Square&, const dvec3& point) {
  return std::abs(point.x) <= 1.0 && std::abs(point.y) <= 1.0;
}

bool covers(const Disc&, const dvec3& point) {
  return point.x * point.x + point.y * point.y <= 1.0;
}

bool covers(const Plane&, const dvec3&) {
  return true;
}

std::optional<Root> plane_root(const LocalRay& ray) {
  if (ray.direction.z == 0.0) return std::nullopt;
  const double t = -ray.origin.z / ray.direction.z;
  return Root{t, plane_root_error(ray, std::abs(ray.direction.z), t, 1.0), {}};
}

Bounds bounds(const Square&, const Transform& to_world) {
  return to_world.box({{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
}

Bounds bounds(const Disc&, const Transform& to_world) {
  return to_world.disc_box(0.0, 1.0);
}

Bounds bounds(const Plane&, const Transform&) {
  return {dvec3(-1e18), dvec3(0.9e18)};
}

} // namespace abbe
