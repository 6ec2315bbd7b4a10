#pragma once

#include "spectral/band_grid.h"
#include "spectral/dispersion.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace abbe {

/// A medium's refractive index, tabulated so finely that the error of linear interpolation is below
/// 1e-7: the step h is 1/16 nm, and n'' stays below 2e-4 per nm^2 in the whole catalogue (rutile at
/// 380 nm is the worst), so that n'' h^2 / 8 is below 1e-7.
class IndexTable {
public:
  /// Vacuum.
  IndexTable() : IndexTable(ConstantIndex{1.0}) {}
  /// With `keep_constant` off an index that does not change is tabulated like any other.
  explicit IndexTable(const Dispersion& law, bool keep_constant = true);

  [[nodiscard]] double at(double lambda_nm) const {
    if (samples_.size() == 1) return samples_[0];
    const double x = (lambda_nm - kLowerNm) / kStepNm;
    const auto i = std::min(static_cast<std::size_t>(x), samples_.size() - 2);
    const double f = x - static_cast<double>(i);
    return samples_[i] + f * (samples_[i + 1] - samples_[i]);
  }
  /// Fills `indices` at `count` wavelengths, `step_nm` apart.
  void fill(double first_nm, double step_nm, int count, double* indices) const {
    if (samples_.size() == 1) {
      std::fill_n(indices, count, samples_[0]);
      return;
    }
    const double x = (first_nm - kLowerNm) / kStepNm, step = step_nm / kStepNm;
    const double* samples = samples_.data();
    const int last = static_cast<int>(samples_.size()) - 2;
    for (int k = 0; k < count; ++k) {
      const double at = x + step * k;
      const int i = std::min(static_cast<int>(at), last);
      indices[k] = samples[i] + (at - i) * (samples[i + 1] - samples[i]);
    }
  }
  [[nodiscard]] bool achromatic() const { return achromatic_; }
  /// How many indices a table of this medium holds, told before it is made.
  [[nodiscard]] static std::size_t count(const Dispersion& law, bool keep_constant = true);

private:
  static constexpr double kStepNm = 0.0625;
  std::vector<double> samples_;
  bool achromatic_ = false;
};

} // namespace abbe
