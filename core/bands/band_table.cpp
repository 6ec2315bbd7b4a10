#include "core/bands/band_table.h"

#include "spectral/observer.h"

#include <algorithm>

namespace abbe {

BandTable::BandTable(const std::vector<double>& values)
    : values_(padded_band_count(static_cast<int>(values.size())), 0.0f) {
  std::transform(values.begin(), values.end(), values_.begin(),
                 [](double v) { return static_cast<float>(v); });
  zero_ = std::all_of(values_.begin(), values_.end(), [](float v) { return v == 0.0f; });
}

BandTable BandTable::at_centers(const BandGrid& grid, const Curve& curve, bool keep_constant) {
  std::vector<double> nm;
  for (int b = 0; b < grid.count(); ++b)
    nm.push_back(grid.center_nm(b));
  return at_wavelengths(nm, curve, keep_constant);
}

BandTable BandTable::at_wavelengths(const std::vector<double>& nm, const Curve& curve,
                                    bool keep_constant) {
  if (const auto constant = curve.constant_value(); constant && keep_constant)
    return {static_cast<float>(*constant), static_cast<int>(nm.size())};
  std::vector<double> values;
  for (const double lambda_nm : nm)
    values.push_back(curve.at(lambda_nm));
  return BandTable(values);
}

BandTable BandTable::plus(float addend, int bands) const {
  if (constant_) return {*constant_ + addend, bands};
  BandTable sum = *this;
  for (int b = 0; b < bands; ++b)
    sum.values_[static_cast<std::size_t>(b)] += addend;
  sum.zero_ =
      std::all_of(sum.values_.begin(), sum.values_.end(), [](float v) { return v == 0.0f; });
  return sum;
}

double band_mean(const Curve& spectrum, const BandGrid& grid) {
  double sum = 0.0;
  for (const double value : band_means(grid, spectrum))
    sum += value;
  return sum / grid.count();
}

} // namespace abbe
