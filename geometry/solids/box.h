#pragma once

#include "geometry/rays/plane_interval.h"
#include "geometry/rays/transform.h"

#include <cmath>
#include <optional>

namespace abbe {

/// The cube from -1 to 1 along each axis. Faces: 2 * axis for the lower, 2 * axis + 1 for the
/// upper.
struct Box {};

/// The part of the ray's line inside the box. With a contact the root of its face is t = 0.
[[nodiscard]] std::optional<PlaneInterval> plane_interval(const Box&, const RayInFrame auto& ray,
                                                          const FaceContact* contact) {
  if (contact && contact->side == Side::outside) return std::nullopt; // convex: never met again
  const Wide o = wide_origin(ray), d = wide_direction(ray), one{1.0, 1.0, 1.0, 1.0};
  // The ray enters through the face it runs against and leaves through the opposite one.
  const Wide sign = d > 0.0 ? one : -one;
  const Wide divisor = d != 0.0 ? d : one; // what is parallel to faces is told apart below
  const Wide t_exit = (sign - o) / divisor, t_enter = (-sign - o) / divisor;
  PlaneInterval inside;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0.0) {
      if (!contact && std::abs(o[axis]) > 1.0) return std::nullopt;
      continue;
    }
    const int exit_face = 2 * axis + (d[axis] > 0.0 ? 1 : 0);
    if (t_exit[axis] < inside.exit.t && !(contact && contact->face == exit_face))
      inside.exit = {t_exit[axis], exit_face};
    if (t_enter[axis] > inside.enter.t) inside.enter = {t_enter[axis], exit_face ^ 1};
  }
  if (contact)
    inside.enter = {0.0, contact->face};
  else if (inside.enter.t > inside.exit.t)
    return std::nullopt;
  return inside;
}
/// The bound of a root's error.
[[nodiscard]] double root_error(const Box&, const RayInFrame auto& ray, const PlaneRoot& root) {
  return plane_root_error(ray, std::abs(ray.direction[root.face / 2]), root.t, 1.0);
}
[[nodiscard]] std::optional<Interval> intersect(const Box& box, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const Box& box, const dvec3& point, int face);
[[nodiscard]] inline dvec3 snapped(const Box&, const dvec3& p, int face) {
  const double at = face % 2 ? 1.0 : -1.0;
  const int axis = face / 2;
  return {axis == 0 ? at : p.x, axis == 1 ? at : p.y, axis == 2 ? at : p.z};
}
/// The nearest of the faces that a ray in this direction does not run in from.
[[nodiscard]] int nearest_face(const Box& box, const dvec3& point, const dvec3& direction);
[[nodiscard]] double signed_distance(const Box& box, const dvec3& point);
[[nodiscard]] Bounds bounds(const Box& box, const Transform& to_world);

} // namespace abbe
