#include "spectral/observer.h"

#include "spectral/data_table.h"

#include <algorithm>

namespace abbe {
namespace {

// The cells that bands are folded from: equal widths over 377.5-782.5 nm.
struct Cells {
  int count;
  double first_nm;
  double step_nm;

  double nm(int cell) const { return first_nm + step_nm * cell; }
  double mean(const Curve& light, int cell) const {
    return light.mean(nm(cell) - 0.5 * step_nm, nm(cell) + 0.5 * step_nm);
  }
};

constexpr Cells kCells5nm{kSampleCount, kFirstSampleNm, kSampleStepNm};
constexpr Cells kCells1nm{405, 378.0, 1.0};

Cells cells_for(const BandGrid& grid) {
  return grid.count() <= kSampleCount ? kCells5nm : kCells1nm;
}

// The colour matching functions at the cells, divided by the sum of ybar, so that the value 1 in
// all cells sums to Y = 1.
std::vector<Xyz> load_observer(std::string_view file_name, const Cells& cells) {
  const DataTable table{embedded_table(file_name)};
  const std::vector<double> nm = table.numbers("nm");
  const std::vector<double> x = table.numbers("xbar");
  const std::vector<double> y = table.numbers("ybar");
  const std::vector<double> z = table.numbers("zbar");
  const auto first = std::find(nm.begin(), nm.end(), cells.first_nm) - nm.begin();
  double sum = 0.0;
  for (int cell = 0; cell < cells.count; ++cell)
    sum += y.at(first + cell);
  std::vector<Xyz> values;
  values.reserve(cells.count);
  for (int cell = 0; cell < cells.count; ++cell)
    values.push_back({x[first + cell] / sum, y[first + cell] / sum, z[first + cell] / sum});
  return values;
}

const std::vector<Xyz>& observer_cells(Observer observer, const Cells& cells) {
  static const std::vector<Xyz> small5 = load_observer("cie1931_2deg_5nm.csv", kCells5nm);
  static const std::vector<Xyz> small1 = load_observer("cie1931_2deg_1nm.csv", kCells1nm);
  static const std::vector<Xyz> large5 = load_observer("cie1964_10deg_5nm.csv", kCells5nm);
  static const std::vector<Xyz> large1 = load_observer("cie1964_10deg_1nm.csv", kCells1nm);
  const bool coarse = cells.count == kCells5nm.count;
  if (observer == Observer::cie1931_2deg) return coarse ? small5 : small1;
  return coarse ? large5 : large1;
}

// Calls visit(cell, part) for each cell that `band` covers, part being the covered fraction of the
// cell. Lengths are counted in units of 1/(bands x cells) of the range, so that they are integers.
template <typename Visit>
void for_each_overlap(int band, int bands, int cells, Visit visit) {
  const int lower = band * cells;
  const int upper = lower + cells;
  for (int cell = lower / bands; cell * bands < upper; ++cell) {
    const int covered = std::min(upper, (cell + 1) * bands) - std::max(lower, cell * bands);
    visit(cell, static_cast<double>(covered) / bands);
  }
}

/// The observer's value at a wavelength, linear in the 1 nm table.
Xyz observer_at(Observer observer, double lambda_nm) {
  const std::vector<Xyz>& cells = observer_cells(observer, kCells1nm);
  const double place = std::clamp(lambda_nm - kCells1nm.first_nm, 0.0, kCells1nm.count - 1.0);
  const auto i = std::min(static_cast<std::size_t>(place), cells.size() - 2);
  const double part = place - static_cast<double>(i);
  return cells[i] * (1.0 - part) + cells[i + 1] * part;
}

std::vector<Xyz> line_weights(const BandGrid& grid, std::span<const SpectralLine> lines,
                              Observer observer) {
  std::vector<Xyz> weights(grid.count());
  for (const SpectralLine& line : lines)
    weights[grid.band_of(line.nm)] += observer_at(observer, line.nm) * line.power;
  return weights;
}

} // namespace

std::vector<Xyz> band_weights(const BandGrid& grid, const Curve& light, Observer observer) {
  if (const auto lines = light.spectral_lines(); !lines.empty())
    return line_weights(grid, lines, observer);
  const Cells cells = cells_for(grid);
  const std::vector<Xyz>& matching = observer_cells(observer, cells);
  std::vector<Xyz> weights(grid.count());
  for (int band = 0; band < grid.count(); ++band)
    for_each_overlap(band, grid.count(), cells.count, [&](int cell, double part) {
      weights[band] += matching[cell] * (part * cells.mean(light, cell));
    });
  return weights;
}

std::vector<double> band_means(const BandGrid& grid, const Curve& light) {
  const Cells cells = cells_for(grid);
  std::vector<double> means(grid.count());
  if (const auto lines = light.spectral_lines(); !lines.empty()) {
    for (const SpectralLine& line : lines)
      means[grid.band_of(line.nm)] += line.power / grid.width_nm();
    return means;
  }
  for (int band = 0; band < grid.count(); ++band) {
    double sum = 0.0;
    double total = 0.0;
    for_each_overlap(band, grid.count(), cells.count, [&](int cell, double part) {
      sum += part * cells.mean(light, cell);
      total += part;
    });
    means[band] = sum / total;
  }
  return means;
}

Xyz to_xyz(const Curve& light, Observer observer) {
  Xyz sum;
  for (const Xyz& weight : band_weights(BandGrid(kSampleCount), light, observer))
    sum += weight;
  return sum;
}

} // namespace abbe
