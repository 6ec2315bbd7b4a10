#pragma once

#include "spectral/color.h"

namespace abbe {

/// CIE 1976 u', v', in which equal distances look more equal than in x, y.
struct UniformChromaticity {
  double u = 0.0;
  double v = 0.0;
  friend bool operator==(const UniformChromaticity&, const UniformChromaticity&) = default;
};

/// u' = 4x / (-2x + 12y + 3) and v' = 9y / (-2x + 12y + 3). (source: CIE15)
[[nodiscard]] constexpr UniformChromaticity uniform(const Chromaticity& c) {
  const double divisor = -2.0 * c.x + 12.0 * c.y + 3.0;
  return {4.0 * c.x / divisor, 9.0 * c.y / divisor};
}

} // namespace abbe
