#pragma once

#include "bench/plots/plot_axis.h"

#include <limits>
#include <string>
#include <vector>

namespace abbe::bench {

/// In the place of a value that there is not.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A value with the range of its repeats, if that is to be shown.
struct PlotValue {
  double value = 0.0;
  double lowest = kNone, highest = kNone;
};

struct PlotPoint {
  double x = 0.0;
  PlotValue y;
};

struct PlotLine {
  std::string name;
  std::vector<PlotPoint> points; ///< joined in this order
};

/// Lines with a mark at each point. What an axis cannot show is left out: a logarithmic one what is
/// not positive, both what is not finite.
struct LinePlot {
  std::string title, x_label, y_label;
  Scale x_scale = Scale::even, y_scale = Scale::even;
  std::vector<PlotLine> lines;
};

struct PlotBars {
  std::string name;
  std::vector<PlotValue> values; ///< by group
};

/// Groups of bars that stand on 0.
struct BarPlot {
  std::string title, y_label;
  std::vector<std::string> groups;
  std::vector<PlotBars> bars;
};

/// The plot as one SVG element, which is a file too.
[[nodiscard]] std::string to_svg(const LinePlot& plot);
[[nodiscard]] std::string to_svg(const BarPlot& plot);

} // namespace abbe::bench
