#pragma once

#include "spectral/curve.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace abbe {

/// A picture of all that surrounds the scene from infinitely far, linear sRGB, rows from the top:
/// columns are equal steps around the y axis and rows equal steps from +y down to -y. The middle
/// is the view along -z, with +x to its right.
struct Environment {
  int width = 0, height = 0;
  std::vector<float> rgb;   ///< interleaved; finite, negative values count as 0
  double factor = 1.0;      ///< on all radiances
  glm::dmat3 to_world{1.0}; ///< orthogonal
  Curve light;              ///< D65 for colours; or one spectrum for all, times the luminance
  bool has_colors = true;   ///< the picture's colours count
};

} // namespace abbe
