#pragma once

#include "bench/plots/markup.h"
#include "bench/plots/plot_axis.h"

namespace abbe::bench {

/// The parts that all plots share: title, axes with grid, legend.
class PlotFrame {
public:
  static constexpr double kLeft = 72.0, kTop = 40.0, kWidth = 400.0, kHeight = 280.0;

  explicit PlotFrame(const std::string& title);

  void x_axis(const PlotAxis& axis, const std::string& label);
  void y_axis(const PlotAxis& axis, const std::string& label);
  /// Names under equal parts of the lower edge, slanted where they are long.
  void groups(const std::vector<std::string>& names);
  // What the mark or the colour of series `i` means.
  void line_legend(std::size_t i, const std::string& name);
  void bar_legend(std::size_t i, const std::string& name);

  /// The mark of series `i`: its shape and its colour differ from those of the others.
  void mark(std::size_t i, double x, double y);
  /// The range of repeats.
  void whisker(double x, double y_low, double y_high);

  [[nodiscard]] static std::string color(std::size_t i);
  [[nodiscard]] static double x(double place) { return kLeft + kWidth * place; }
  [[nodiscard]] static double y(double place) { return kTop + kHeight * (1.0 - place); }

  Markup svg;

private:
  void legend_text(std::size_t i, const std::string& name);
};

} // namespace abbe::bench
