#include "bench/plots/plot.h"

#include "bench/plots/plot_frame.h"

#include <algorithm>
#include <cmath>

namespace abbe::bench {
namespace {

/// Adds a value and the ends of its range to what an axis must show.
void include(std::vector<double>& shown, const PlotValue& value) {
  for (const double v : {value.value, value.lowest, value.highest})
    if (std::isfinite(v)) shown.push_back(v);
}

bool has_range(const PlotValue& value, const PlotAxis& axis) {
  return std::isfinite(value.lowest) && std::isfinite(value.highest) && axis.shows(value.lowest) &&
         axis.shows(value.highest);
}

void add_range(PlotFrame& frame, const PlotAxis& axis, const PlotValue& value, double x) {
  if (has_range(value, axis))
    frame.whisker(x, PlotFrame::y(axis.place(value.lowest)),
                  PlotFrame::y(axis.place(value.highest)));
}

} // namespace

std::string to_svg(const LinePlot& plot) {
  std::vector<double> xs, ys;
  for (const PlotLine& line : plot.lines)
    for (const PlotPoint& p : line.points) {
      xs.push_back(p.x);
      include(ys, p.y);
    }
  const PlotAxis x_axis(xs, plot.x_scale, false), y_axis(ys, plot.y_scale, true);
  PlotFrame frame(plot.title);
  frame.x_axis(x_axis, plot.x_label);
  frame.y_axis(y_axis, plot.y_label);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    frame.line_legend(i, plot.lines[i].name);
    std::string path;
    std::vector<PlotPoint> shown;
    for (const PlotPoint& p : plot.lines[i].points)
      if (std::isfinite(p.x) && std::isfinite(p.y.value) && x_axis.shows(p.x) &&
          y_axis.shows(p.y.value))
        shown.push_back(p);
    for (const PlotPoint& p : shown)
      path += (path.empty() ? "M" : " L") + coordinate(PlotFrame::x(x_axis.place(p.x))) + " " +
              coordinate(PlotFrame::y(y_axis.place(p.y.value)));
    if (shown.size() > 1)
      frame.svg.element(
          "path",
          {{"d", path}, {"fill", "none"}, {"stroke", PlotFrame::color(i)}, {"stroke-width", "2"}});
    for (const PlotPoint& p : shown) {
      const double x = PlotFrame::x(x_axis.place(p.x));
      add_range(frame, y_axis, p.y, x);
      frame.mark(i, x, PlotFrame::y(y_axis.place(p.y.value)));
    }
  }
  return frame.svg.finish();
}

std::string to_svg(const BarPlot& plot) {
  std::vector<double> ys;
  for (const PlotBars& bars : plot.bars)
    for (const PlotValue& value : bars.values)
      include(ys, value);
  const PlotAxis y_axis(ys, Scale::even, true);
  PlotFrame frame(plot.title);
  frame.y_axis(y_axis, plot.y_label);
  frame.groups(plot.groups);
  const double group =
      PlotFrame::kWidth / static_cast<double>(std::max<std::size_t>(plot.groups.size(), 1));
  const double width =
      0.8 * group / static_cast<double>(std::max<std::size_t>(plot.bars.size(), 1));
  const double floor = PlotFrame::y(y_axis.place(0.0));
  for (std::size_t i = 0; i < plot.bars.size(); ++i) {
    frame.bar_legend(i, plot.bars[i].name);
    for (std::size_t k = 0; k < plot.bars[i].values.size(); ++k) {
      const PlotValue& value = plot.bars[i].values[k];
      if (!std::isfinite(value.value)) continue;
      const double left = PlotFrame::kLeft + group * (static_cast<double>(k) + 0.1) +
                          width * static_cast<double>(i);
      const double top = PlotFrame::y(y_axis.place(value.value));
      frame.svg.element("rect", {{"x", coordinate(left)},
                                 {"y", coordinate(std::min(top, floor))},
                                 {"width", coordinate(width)},
                                 {"height", coordinate(std::abs(floor - top))},
                                 {"fill", PlotFrame::color(i)}});
      add_range(frame, y_axis, value, left + 0.5 * width);
    }
  }
  return frame.svg.finish();
}

} // namespace abbe::bench
