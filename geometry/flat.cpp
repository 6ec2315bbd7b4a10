#include "geometry/flat.h"

#include <cmath>

namespace abbe {

std::optional<Root> intersect(const Square&, const LocalRay& ray) {
  if (ray.direction.z == 0.0) return std::nullopt; // in the plane, or beside it: no area is seen
  const double t = -ray.origin.z / ray.direction.z;
  const dvec3 p = ray.at(t);
  if (std::abs(p.x) > 1.0 || std::abs(p.y) > 1.0) return std::nullopt;
  return Root{t, plane_root_error(ray, std::abs(ray.direction.z), t, 1.0), {}};
}

dvec3 outward_normal(const Square&, const dvec3&, int) {
  return {0.0, 0.0, 1.0};
}

dvec3 snapped(const Square&, const dvec3& point, int) {
  return {point.x, point.y, 0.0};
}

Bounds bounds(const Square&, const Transform& to_world) {
  return to_world.box({{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
}

} // namespace abbe
