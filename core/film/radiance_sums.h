#pragma once

#include "core/bands/band_span.h"
#include "core/film/radiance_parts.h"
#include "core/plan/plan.h"
#include "spectral/color.h"

#include <span>
#include <vector>

namespace abbe {

/// What one camera sample gathers: a sum over bands for each of the plan's accumulators.
class RadianceSums {
public:
  /// `apart`: what the photon map brings is kept apart, so that `own_color` is known.
  explicit RadianceSums(const Plan& plan, bool apart = false);

  /// From now on what is added is also divided; null: not any more. Keeps the pointer.
  void divide(RadianceParts* parts) { parts_ = parts; }
  [[nodiscard]] bool divided() const { return parts_ != nullptr; }
  /// Says what the light that comes next is a part of. Only sums that are divided may be asked.
  void classify(View view, Arrival arrival) { parts_->classify(view, arrival); }

  void clear();
  /// Adds throughput * reflectance * factor of a source's light, for the bands of `throughput`.
  void add(int source, BandSpan<const float> throughput, const BandTable& reflectance,
           float factor);
  /// The same for light that a photon map brings.
  void add_mapped(int source, BandSpan<const float> throughput, const BandTable& reflectance,
                  float factor);

  /// Adds what passes through the scene to what lies behind it. `alpha`: it makes the picture
  /// transparent.
  void let_through(BandSpan<const float> throughput, bool alpha);

  [[nodiscard]] Xyz color() const;
  /// The color without what a photon map brings: a function of the sample's random numbers alone.
  [[nodiscard]] Xyz own_color() const;
  /// What each band adds to the color; the span is valid until the next call.
  [[nodiscard]] std::span<const Xyz> band_colors();
  /// Mean spectral radiance per band; the span is valid until the next call.
  [[nodiscard]] std::span<const float> radiance();

  /// The share of luminance that passes and makes the picture transparent: 1 where nothing is lost.
  [[nodiscard]] double transparency() const { return transparency_; }
  /// The colour of D65 of Y = 1 after it has passed, where the plan asks for it.
  [[nodiscard]] const Xyz& transmittance() const { return transmittance_; }

private:
  void add_to(double* sum, const BandTable& light, BandSpan<const float> throughput,
              const BandTable& reflectance, float factor);
  /// The color of all accumulators from this one on, as many as the plan has.
  [[nodiscard]] Xyz color_from(std::size_t accumulator) const;
  [[nodiscard]] double* sums(std::size_t accumulator) {
    return sums_.data() + accumulator * plan_.stride;
  }

  const Plan& plan_;
  std::size_t mapped_;       ///< the first accumulator of light that a photon map brings
  std::vector<double> sums_; ///< in double: deep trees add millions of faint terms
  double transparency_ = 0.0;
  Xyz transmittance_{0.0, 0.0, 0.0};
  RadianceParts* parts_ = nullptr;
  BandRange used_; ///< the sums outside are 0
  std::vector<float> radiance_;
  std::vector<Xyz> band_colors_; ///< empty until they are asked for
};

} // namespace abbe
