#include "bench/plots/plot_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace abbe::bench {
namespace {

constexpr double kLegendLeft = PlotFrame::kLeft + PlotFrame::kWidth + 16.0;
constexpr double kAllWidth = kLegendLeft + 172.0;
constexpr double kAllHeight = PlotFrame::kTop + PlotFrame::kHeight + 80.0;
constexpr double kLetter = 6.6; // mean width of one at 12 pixels
constexpr const char* kGrey = "#555555";

/// Colours that eyes without one kind of cone tell apart too [OkabeIto08], without the yellow,
/// which is too light for lines on white.
constexpr std::array kColors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                             "#E69F00", "#56B4E9", "#000000"};

double legend_y(std::size_t i) {
  return PlotFrame::kTop + 10.0 + 20.0 * static_cast<double>(i);
}

} // namespace

std::string PlotFrame::color(std::size_t i) {
  return kColors[i % kColors.size()];
}

PlotFrame::PlotFrame(const std::string& title) {
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", fmt::format("0 0 {} {}", kAllWidth, kAllHeight)},
                   {"width", coordinate(kAllWidth)},
                   {"height", coordinate(kAllHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"},
                   {"font-size", "12"},
                   {"fill", "#222222"}});
  svg.element(
      "rect",
      {{"width", coordinate(kAllWidth)}, {"height", coordinate(kAllHeight)}, {"fill", "#ffffff"}});
  svg.text("text", {{"x", coordinate(kLeft)}, {"y", "22"}, {"font-size", "15"}}, title);
  svg.element("rect", {{"x", coordinate(kLeft)},
                       {"y", coordinate(kTop)},
                       {"width", coordinate(kWidth)},
                       {"height", coordinate(kHeight)},
                       {"fill", "none"},
                       {"stroke", kGrey}});
}

void PlotFrame::x_axis(const PlotAxis& axis, const std::string& label) {
  for (const Tick& tick : axis.ticks()) {
    const std::string at = coordinate(x(axis.place(tick.value)));
    const bool small = tick.label.empty();
    svg.element("line", {{"x1", at},
                         {"x2", at},
                         {"y1", coordinate(small ? y(0.0) - 4.0 : kTop)},
                         {"y2", coordinate(y(0.0))},
                         {"stroke", small ? kGrey : "#dddddd"}});
    svg.text("text", {{"x", at}, {"y", coordinate(y(0.0) + 17.0)}, {"text-anchor", "middle"}},
             tick.label);
  }
  svg.text("text",
           {{"x", coordinate(x(0.5))}, {"y", coordinate(y(0.0) + 40.0)}, {"text-anchor", "middle"}},
           label);
}

void PlotFrame::y_axis(const PlotAxis& axis, const std::string& label) {
  for (const Tick& tick : axis.ticks()) {
    const double at = y(axis.place(tick.value));
    const bool small = tick.label.empty();
    svg.element("line", {{"x1", coordinate(kLeft)},
                         {"x2", coordinate(small ? kLeft + 4.0 : x(1.0))},
                         {"y1", coordinate(at)},
                         {"y2", coordinate(at)},
                         {"stroke", small ? kGrey : "#dddddd"}});
    svg.text("text",
             {{"x", coordinate(kLeft - 6.0)}, {"y", coordinate(at + 4.0)}, {"text-anchor", "end"}},
             tick.label);
  }
  const std::string middle = coordinate(y(0.5));
  svg.text("text",
           {{"x", "16"},
            {"y", middle},
            {"text-anchor", "middle"},
            {"transform", fmt::format("rotate(-90 16 {})", middle)}},
           label);
}

void PlotFrame::groups(const std::vector<std::string>& names) {
  const double each = 1.0 / static_cast<double>(std::max<std::size_t>(names.size(), 1));
  std::size_t longest = 0;
  for (const std::string& name : names)
    longest = std::max(longest, name.size());
  const bool slanted = static_cast<double>(longest) * kLetter > kWidth * each;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string at_x = coordinate(x((static_cast<double>(i) + 0.5) * each));
    const std::string at_y = coordinate(y(0.0) + 17.0);
    if (slanted)
      svg.text("text",
               {{"x", at_x},
                {"y", at_y},
                {"text-anchor", "end"},
                {"transform", fmt::format("rotate(-30 {} {})", at_x, at_y)}},
               names[i]);
    else
      svg.text("text", {{"x", at_x}, {"y", at_y}, {"text-anchor", "middle"}}, names[i]);
  }
}

void PlotFrame::line_legend(std::size_t i, const std::string& name) {
  mark(i, kLegendLeft + 4.0, legend_y(i));
  legend_text(i, name);
}

void PlotFrame::bar_legend(std::size_t i, const std::string& name) {
  svg.element("rect", {{"x", coordinate(kLegendLeft - 1.0)},
                       {"y", coordinate(legend_y(i) - 5.0)},
                       {"width", "10"},
                       {"height", "10"},
                       {"fill", color(i)}});
  legend_text(i, name);
}

void PlotFrame::legend_text(std::size_t i, const std::string& name) {
  svg.text("text", {{"x", coordinate(kLegendLeft + 16.0)}, {"y", coordinate(legend_y(i) + 4.0)}},
           name);
}

void PlotFrame::mark(std::size_t i, double x, double y) {
  const std::string fill = color(i);
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> corners) {
    std::string points;
    for (const auto& [dx, dy] : corners)
      points += coordinate(x + dx) + "," + coordinate(y + dy) + " ";
    points.pop_back();
    svg.element("polygon", {{"points", points}, {"fill", fill}});
  };
  switch (i % 4) {
  case 0:
    svg.element("circle",
                {{"cx", coordinate(x)}, {"cy", coordinate(y)}, {"r", "4"}, {"fill", fill}});
    break;
  case 1:
    polygon({{-3.5, -3.5}, {3.5, -3.5}, {3.5, 3.5}, {-3.5, 3.5}});
    break;
  case 2:
    polygon({{0.0, -4.5}, {4.2, 3.5}, {-4.2, 3.5}});
    break;
  default:
    polygon({{0.0, -5.0}, {4.5, 0.0}, {0.0, 5.0}, {-4.5, 0.0}});
  }
}

void PlotFrame::whisker(double x, double y_low, double y_high) {
  const auto line = [&](double x1, double y1, double x2, double y2) {
    svg.element("line", {{"x1", coordinate(x1)},
                         {"y1", coordinate(y1)},
                         {"x2", coordinate(x2)},
                         {"y2", coordinate(y2)},
                         {"stroke", "#222222"}});
  };
  line(x, y_low, x, y_high);
  line(x - 3.0, y_low, x + 3.0, y_low);
  line(x - 3.0, y_high, x + 3.0, y_high);
}

} // namespace abbe::bench
