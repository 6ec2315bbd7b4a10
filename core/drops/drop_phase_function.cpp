#include "core/drops/drop_phase_function.h"

#include "core/drops/disc_blur.h"
#include "core/drops/drop_optics.h"
#include "spectral/band_grid.h"
#include "spectral/glass.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace abbe {
namespace {

const Dispersion& catalogue_index(const char* name) {
  const Glass* glass = find_glass(name);
  if (!glass) throw std::logic_error(std::string("glass.csv has no ") + name);
  return glass->dispersion;
}

} // namespace

Dispersion water_in_air() {
  const Dispersion &water = catalogue_index("water-20C"), &air = catalogue_index("air-15C");
  std::vector<double> nm, n;
  for (double lambda = kLowerNm; lambda <= kUpperNm; lambda += 0.5 * kSampleStepNm) {
    nm.push_back(lambda);
    n.push_back(refractive_index(water, lambda) / refractive_index(air, lambda));
  }
  return tabulated_index(std::move(nm), std::move(n));
}

DropPhaseFunction::DropPhaseFunction(const Dispersion& index,
                                     const std::vector<std::vector<double>>& wavelengths_nm,
                                     double disc_radius, std::size_t cells)
    : cells_(cells), stride_(padded_band_count(static_cast<int>(wavelengths_nm.size()))),
      values_(cells * stride_) {
  const DiscBlur blur(cells, disc_radius);
  double last_n = 0.0;
  std::vector<double> of_n, sum(cells);
  for (std::size_t band = 0; band < wavelengths_nm.size(); ++band) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (const double nm : wavelengths_nm[band]) {
      const double n = refractive_index(index, nm);
      if (n != last_n) {
        of_n.assign(cells, 0.0);
        add_drop_flux(n, 0, kLastOrder, of_n);
        last_n = n;
      }
      for (std::size_t j = 0; j < cells; ++j)
        sum[j] += of_n[j] / static_cast<double>(wavelengths_nm[band].size());
    }
    blur.apply(sum);
    for (std::size_t j = 0; j < cells; ++j)
      values_[j * stride_ + band] = static_cast<float>(sum[j] / solid_angle(j));
  }
}

double DropPhaseFunction::solid_angle(std::size_t cell) const {
  const double half = 0.5 * std::numbers::pi / static_cast<double>(cells_);
  return 4.0 * std::numbers::pi * std::sin(half * static_cast<double>(2 * cell + 1)) *
         std::sin(half);
}

double DropPhaseFunction::flux(std::size_t cell, int band) const {
  return static_cast<double>(values_[cell * stride_ + static_cast<std::size_t>(band)]) *
         solid_angle(cell);
}

DropPhaseFunction::Place DropPhaseFunction::at(double cosine) const {
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  const auto last = static_cast<double>(cells_ - 1);
  const double place =
      std::clamp(angle / std::numbers::pi * static_cast<double>(cells_) - 0.5, 0.0, last);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, cells_ - 1);
  return {values_.data() + below * stride_, values_.data() + above * stride_,
          static_cast<float>(place - static_cast<double>(below))};
}

} // namespace abbe
