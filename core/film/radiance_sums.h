#pragma once

#include "core/bands/band_span.h"
#include "core/plan/plan.h"
#include "spectral/color.h"

#include <span>
#include <vector>

namespace abbe {

/// What one camera sample gathers: a sum over bands for each of the plan's accumulators.
class RadianceSums {
public:
  explicit RadianceSums(const Plan& plan);

  void clear();
  /// Adds throughput * reflectance * factor of a source's light, for the bands of `throughput`.
  void add(int source, BandSpan<const float> throughput, const BandTable& reflectance,
           float factor);

  [[nodiscard]] Xyz color() const;
  /// Mean spectral radiance per band; the span is valid until the next call.
  [[nodiscard]] std::span<const float> radiance();

private:
  [[nodiscard]] double* sums(int accumulator) {
    return sums_.data() + static_cast<std::size_t>(accumulator) * plan_.stride;
  }

  const Plan& plan_;
  std::vector<double> sums_; ///< in double: deep trees add millions of faint terms
  BandRange used_;           ///< the sums outside are 0
  std::vector<float> radiance_;
};

} // namespace abbe
