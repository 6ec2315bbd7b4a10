#pragma once

#include "spectral/color.h"

#include <vector>

namespace abbe {

/// The mean over pixels and linear RGB of (x - r)^2 / (r^2 + 0.01 mean(r)^2), where the mean of r
/// is over pixels and channels. The images have the same size, and pixels.
[[nodiscard]] double relative_mse(const std::vector<LinearRgb>& image,
                                  const std::vector<LinearRgb>& reference);

/// The value below which `fraction` of all lie; the lowest and highest for 0 and 1. Linear between
/// neighbours. There must be values.
[[nodiscard]] double quantile(std::vector<double> values, double fraction);

} // namespace abbe
