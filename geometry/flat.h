#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"
#include "geometry/transform.h"

#include <optional>

namespace abbe {

/// The square from -1 to 1 in x and y, in the plane z = 0. It has no inside; its normal is +z.
struct Square {};

/// Where the line meets the square. A ray that leaves a flat surface never meets it again.
[[nodiscard]] std::optional<Root> intersect(const Square& square, const LocalRay& ray);
[[nodiscard]] dvec3 outward_normal(const Square& square, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const Square& square, const dvec3& point, int face);
[[nodiscard]] Bounds bounds(const Square& square, const Transform& to_world);

} // namespace abbe
