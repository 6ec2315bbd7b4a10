#include "io/plots/plot.h"

#include "spectral/band_grid.h"
#include "spectral/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace abbe {
namespace {

constexpr int kColumns = 68, kRows = 16;
constexpr std::array<std::string_view, 9> kBlocks{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};

/// One line of bars. `row` counts from the bottom.
std::string bars(const std::vector<double>& values, const PlotRange& range, int row) {
  std::string line;
  for (const double value : values) {
    const double height =
        (value - range.lowest) / (range.highest - range.lowest) * kRows * 8.0 - 8.0 * row;
    line += kBlocks[static_cast<std::size_t>(std::lround(std::clamp(height, 0.0, 8.0)))];
  }
  return line;
}

/// The axis with its ticks, and the wavelengths below them.
std::string axis() {
  std::string line, labels(kColumns, ' ');
  const BandGrid grid(kColumns);
  for (int column = 0; column < kColumns; ++column) {
    const int hundred = static_cast<int>(std::lround(grid.center_nm(column) / 100.0)) * 100;
    const bool tick = hundred < kUpperNm && grid.band_of(hundred) == column;
    line += tick ? "┬" : "─";
    if (tick)
      labels.replace(static_cast<std::size_t>(std::max(column - 1, 0)), 3,
                     fmt::format("{}", hundred));
  }
  return fmt::format("{:>10} └{}\n{:>10}  {} nm\n", "", line, "", labels);
}

} // namespace

std::vector<double> means_of(const Curve& curve, int count) {
  const BandGrid grid(count);
  if (!curve.spectral_lines().empty()) return band_means(grid, curve);
  std::vector<double> values;
  for (int b = 0; b < count; ++b)
    values.push_back(curve.at(grid.center_nm(b)));
  return values;
}

PlotRange range_of(const std::vector<double>& values, bool from_zero) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  PlotRange range{from_zero ? std::min(0.0, *least) : *least, *greatest};
  if (!from_zero) range.lowest -= 0.05 * (range.highest - range.lowest);
  if (!(range.highest > range.lowest)) range.highest = range.lowest + 1.0;
  return range;
}

std::string plot_text(const Plot& plot) {
  const std::vector<double> values = plot.values(kColumns);
  const PlotRange range = range_of(values, plot.from_zero);
  std::string text = plot.title + "\n";
  for (int row = kRows - 1; row >= 0; --row) {
    const double top = range.lowest + (range.highest - range.lowest) * (row + 1) / kRows;
    const bool labelled = (kRows - 1 - row) % 5 == 0;
    text += fmt::format("{:>10} {}{}\n", labelled ? fmt::format("{:.5g}", top) : "",
                        labelled ? "┤" : "│", bars(values, range, row));
  }
  return text + axis();
}

} // namespace abbe
