#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"
#include "geometry/transform.h"

#include <optional>

namespace abbe {

/// The cube from -1 to 1 along each axis. Faces: 2 * axis for the lower, 2 * axis + 1 for the
/// upper.
struct Box {};

[[nodiscard]] std::optional<Interval> intersect(const Box& box, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const Box& box, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const Box& box, const dvec3& point, int face);
[[nodiscard]] int nearest_face(const Box& box, const dvec3& point);
[[nodiscard]] double signed_distance(const Box& box, const dvec3& point);
[[nodiscard]] Bounds bounds(const Box& box, const Transform& to_world);

} // namespace abbe
