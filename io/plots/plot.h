#pragma once

#include "core/image/image.h"
#include "spectral/curve.h"

#include <functional>
#include <string>

namespace abbe {

/// A curve to be drawn over the wavelengths of the renderer.
struct Plot {
  std::string title; ///< one line, with the unit of the values
  /// Mean values over a number of equal parts of 377.5-782.5 nm.
  std::function<std::vector<double>(int count)> values;
  bool from_zero = true; ///< the axis begins at 0, not at the least value
};

/// A curve's means: of lines their power over the width of a part, else the value at its centre.
[[nodiscard]] std::vector<double> means_of(const Curve& curve, int count);

/// The plot in characters, at most 80 columns: bars in eighths of a block over an axis in nm.
[[nodiscard]] std::string plot_text(const Plot& plot);

/// The plot as a picture of 900 x 420 pixels with an axis in nm and three values.
[[nodiscard]] DisplayImage plot_image(const Plot& plot);

/// The ends of the axis of values: 0 or a little below the least, and the greatest.
struct PlotRange {
  double lowest = 0.0, highest = 1.0;
};
[[nodiscard]] PlotRange range_of(const std::vector<double>& values, bool from_zero);

} // namespace abbe
