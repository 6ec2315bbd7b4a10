#include "geometry/box.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

Root with_error(const LocalRay& ray, Root root) {
  root.t_error = plane_root_error(ray, std::abs(ray.direction[root.face.face / 2]), root.t, 1.0);
  return root;
}

} // namespace

std::optional<Interval> intersect(const Box&, const LocalRay& ray, const FaceContact* contact) {
  if (contact && contact->side == Side::outside) return std::nullopt; // convex: never met again
  Interval inside;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0.0) {
      if (!contact && std::abs(o) > 1.0) return std::nullopt;
      continue;
    }
    // The ray enters through the face it runs against and leaves through the opposite one.
    const int exit_face = 2 * axis + (d > 0.0 ? 1 : 0);
    const double sign = d > 0.0 ? 1.0 : -1.0;
    const double t_exit = (sign - o) / d;
    if (t_exit < inside.exit.t && !(contact && contact->face == exit_face))
      inside.exit = {t_exit, 0.0, {0, exit_face}};
    const double t_enter = (-sign - o) / d;
    if (t_enter > inside.enter.t) inside.enter = {t_enter, 0.0, {0, exit_face ^ 1}};
  }
  if (contact) {
    inside.enter = {0.0, 0.0, {0, contact->face}};
    inside.exit = with_error(ray, inside.exit);
    inside.exit.t = std::max(0.0, inside.exit.t);
    return inside;
  }
  if (inside.enter.t > inside.exit.t) return std::nullopt;
  return Interval{with_error(ray, inside.enter), with_error(ray, inside.exit)};
}

dvec3 outward_normal(const Box&, const dvec3&, int face) {
  dvec3 n(0.0);
  n[face / 2] = face % 2 ? 1.0 : -1.0;
  return n;
}

dvec3 snapped(const Box&, const dvec3& point, int face) {
  dvec3 p = point;
  p[face / 2] = face % 2 ? 1.0 : -1.0;
  return p;
}

int nearest_face(const Box&, const dvec3& point) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(point[i]) > std::abs(point[axis])) axis = i;
  return 2 * axis + (point[axis] > 0.0 ? 1 : 0);
}

double signed_distance(const Box&, const dvec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) - 1.0;
}

Bounds bounds(const Box&, const Transform& to_world) {
  return to_world.box({dvec3(-1.0), dvec3(1.0)});
}

} // namespace abbe
