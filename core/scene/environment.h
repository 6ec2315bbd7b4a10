#pragma once

#include "spectral/curve.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace abbe {

/// An image, in linear sRGB, of what surrounds the scene at an infinite distance. Columns are equal
/// steps around the y axis, and rows equal steps from +y down to -y. The middle shows the direction
/// -z, with +x to its right.
struct Environment {
  int width = 0, height = 0;
  std::vector<float> rgb;   ///< interleaved, rows from the top; finite, negative values count as 0
  double factor = 1.0;      ///< multiplies all radiances
  glm::dmat3 to_world{1.0}; ///< orthogonal
  Curve light;              ///< D65 with colours; without, the spectrum of all pixels
  bool has_colors = true;   ///< without, only the pixels' luminance counts
};

} // namespace abbe
