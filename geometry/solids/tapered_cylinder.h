#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/local_ray.h"
#include "geometry/rays/transform.h"

#include <optional>

namespace abbe {

/// The solid of revolution about z with radius 1 at z = 0 and `top_radius` (0 or more) at z = 1:
/// a cylinder where that is 1, a cone where it is 0. Faces: 0 side, 1 bottom, 2 top.
struct TaperedCylinder {
  double top_radius = 1.0;

  /// How the radius changes with z.
  [[nodiscard]] double slope() const { return top_radius - 1.0; }
};

[[nodiscard]] std::optional<Interval> intersect(const TaperedCylinder& solid, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const TaperedCylinder& solid, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const TaperedCylinder& solid, const dvec3& point, int face);
/// The nearest of the faces that a ray in this direction does not run in from.
[[nodiscard]] int nearest_face(const TaperedCylinder& solid, const dvec3& point,
                               const dvec3& direction);
[[nodiscard]] double signed_distance(const TaperedCylinder& solid, const dvec3& point);
[[nodiscard]] Bounds bounds(const TaperedCylinder& solid, const Transform& to_world);

} // namespace abbe
