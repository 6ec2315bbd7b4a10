#pragma once

#include "geometry/rays/ray.h"

#include <cmath>

namespace abbe {

/// False where a coordinate is infinite or no number. Such a ray meets nothing, and is not traced.
[[nodiscard]] inline bool is_finite(const Ray& ray) {
  const dvec3 sums = ray.origin + ray.direction;
  const double sum = sums.x + sums.y + sums.z;
  return std::isfinite(sum);
}

} // namespace abbe
