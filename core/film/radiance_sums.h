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

  /// Adds what passes through the scene to what lies behind it. `alpha`: it makes the picture
  /// transparent.
  void let_through(BandSpan<const float> throughput, bool alpha);

  [[nodiscard]] Xyz color() const;
  /// Mean spectral radiance per band; the span is valid until the next call.
  [[nodiscard]] std::span<const float> radiance();

  /// The share of luminance that passes and makes the picture transparent: 1 where nothing is lost.
  [[nodiscard]] double transparency() const { return transparency_; }
  /// The colour of D65 of Y = 1 after it has passed, where the plan asks for it.
  [[nodiscard]] const Xyz& transmittance() const { return transmittance_; }

private:
  [[nodiscard]] double* sums(int accumulator) {
    return sums_.data() + static_cast<std::size_t>(accumulator) * plan_.stride;
  }

  const Plan& plan_;
  std::vector<double> sums_; ///< in double: deep trees add millions of faint terms
  double transparency_ = 0.0;
  Xyz transmittance_{0.0, 0.0, 0.0};
  BandRange used_; ///< the sums outside are 0
  std::vector<float> radiance_;
};

} // namespace abbe
