#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"
#include "geometry/transform.h"

#include <optional>

namespace abbe {

/// The ball of radius 1 about the origin of its frame. It has one face, number 0.
struct Sphere {};

/// The part of the ray's line inside the ball. With a contact the root of the surface is t = 0.
[[nodiscard]] std::optional<Interval> intersect(const Sphere& sphere, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const Sphere& sphere, const dvec3& point, int face);
/// The nearest point of the surface to a point known to lie on it but for rounding.
[[nodiscard]] dvec3 snapped(const Sphere& sphere, const dvec3& point, int face);
[[nodiscard]] int nearest_face(const Sphere& sphere, const dvec3& point);
/// Negative inside, positive outside, zero on the surface; near the surface it is the distance.
[[nodiscard]] double signed_distance(const Sphere& sphere, const dvec3& point);
[[nodiscard]] Bounds bounds(const Sphere& sphere, const Transform& to_world);

} // namespace abbe
