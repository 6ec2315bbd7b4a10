#pragma once

#include "geometry/world/shape.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {

/// Where shapes, lights and cameras may be. Bounds are padded by 2^-20 of the farthest coordinate,
/// which must not reach Embree's limit of 1.8e18.
inline constexpr double kFarthestCoordinate = 1e17;

/// The largest coordinate of a place.
[[nodiscard]] inline double reach_of(const dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The largest coordinate of a shape; of an endless plane that of its point next to the origin.
[[nodiscard]] inline double reach_of(const PlacedShape& placed) {
  if (is_bounded(placed.shape)) return bounds(placed).largest_coordinate();
  const dvec3 normal = placed.to_world.normal({0.0, 0.0, 1.0});
  return std::abs(glm::dot(normal, placed.to_world.offset()));
}

} // namespace abbe
