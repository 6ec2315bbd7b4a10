#pragma once

#include "core/scene/settings.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace abbe {

using glm::dvec2;

/// A stream of independent numbers in [0, 1) for yes-or-no decisions along a path.
class DecisionStream {
public:
  explicit DecisionStream(std::uint64_t key = 0) : state_(key) {}
  [[nodiscard]] double next();

private:
  std::uint64_t state_;
};

/// The random numbers of one camera sample. They depend on pixel, sample index and seed alone.
/// Each pair of dimensions is an Owen-scrambled Sobol' (0,2)-sequence over the sample index
/// [Burley20], so any power-of-two number of samples is stratified in it.
class Sampler {
public:
  Sampler(int pixel_x, int pixel_y, std::uint32_t sample_index, std::uint64_t seed);

  /// Two numbers in [0, 1) for one purpose. Purposes are statistically independent.
  [[nodiscard]] dvec2 pair(std::uint32_t purpose) const;
  /// The path's stream of decisions; the same each time it is asked for.
  [[nodiscard]] DecisionStream decisions() const;

private:
  std::uint32_t reversed_index_; ///< the sample's, its bits reversed
  std::uint64_t key_;
};

/// What the pairs of numbers of a camera sample are for.
enum SamplePurpose : std::uint32_t {
  kPixelPosition = 0,
  kWavelength = 1,        ///< x: place inside the band, y: which band of a stratum is kept
  kLens = 2,              ///< where on the lens
  kDropPlace = 6,         ///< x: where drops on the way are looked at, y: which lamp lights them
  kDropLamp = 7,          ///< a point on it
  kEmissionPoint = 4,     ///< where a light path begins on its lamp
  kEmissionDirection = 5, ///< and where it goes
  // From here on purposes repeat for each surface along a path, `kPerSurface` apart.
  kScatter = 8,        ///< x: which part of the surface's scattering, y: whether the path goes on
  kDirection = 9,      ///< of a ray that is spread
  kLamp = 10,          ///< x: which lamp
  kLampPoint = 11,     ///< a point on it
  kSurfaceChoice = 12, ///< x: which band of a stratum is kept, y: which of mixed materials
  kSplat = 13,         ///< where in the pixel filter a splat falls
  kLobe = 14,          ///< x: which way of a rough surface's scattering, y: by which band
  kSplatRounding = 15, ///< x: whether the film rounds a splat up or down
  kPerSurface = 8,
};

/// A position relative to the pixel's centre, in pixels, distributed like the filter.
[[nodiscard]] dvec2 filter_offset(PixelFilter filter, const dvec2& u);

/// The density of `filter_offset` in either coordinate, per pixel.
[[nodiscard]] double filter_density(PixelFilter filter, double offset);

/// How far from the pixel's centre the filter reaches, in pixels.
[[nodiscard]] double filter_radius(PixelFilter filter);

} // namespace abbe
