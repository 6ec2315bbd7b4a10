#include "core/band_table.h"

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

} // namespace abbe
