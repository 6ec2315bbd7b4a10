#pragma once

#include "geometry/rays/ray.h"

#include <algorithm>
#include <cmath>

namespace abbe {

/// The largest magnitude of a component. A vector divided by it has a length that neither overflows
/// nor vanishes.
[[nodiscard]] inline double largest_component(const dvec3& v) {
  return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

} // namespace abbe
