#pragma once

#include "core/scene/settings.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace abbe {

using glm::dvec2;

/// A stream of independent random numbers in [0, 1) for the decisions along a path.
class DecisionStream {
public:
  explicit DecisionStream(std::uint64_t key = 0) : state_(key) {}
  [[nodiscard]] double next();

private:
  std::uint64_t state_;
};

/// The random numbers of one camera sample or light path. They depend on pixel, sample index and
/// seed alone.
/// Each pair of dimensions is an Owen-scrambled Sobol' (0,2)-sequence over the sample index
/// [Burley20], so the samples are stratified wherever their number is a power of two.
class Sampler {
public:
  Sampler(int pixel_x, int pixel_y, std::uint32_t sample_index, std::uint64_t seed);

  /// Two numbers in [0, 1) for one purpose. Purposes are statistically independent.
  [[nodiscard]] dvec2 pair(std::uint32_t purpose) const;
  /// One of the path's streams of decisions. Each call returns the same stream from its start.
  [[nodiscard]] DecisionStream decisions(std::uint64_t stream = 0) const;

private:
  std::uint32_t reversed_index_; ///< the sample's index with its bits reversed
  std::uint64_t key_;
};

/// What a pair of numbers is for. The value is part of the key of the numbers, so that a new value
/// for a purpose changes every image; 3 is free.
enum SamplePurpose : std::uint32_t {
  // These occur once for each camera sample or light path.
  kPixelPosition = 0,     ///< the place in the pixel filter
  kWavelength = 1,        ///< x: the place inside the bands, y: the band that stands for a stratum
  kLens = 2,              ///< the place on the lens
  kEmissionPoint = 4,     ///< the place on its light at which a light path begins
  kEmissionDirection = 5, ///< the direction in which it begins
  kDropPlace = 6, ///< x: the place on a ray where drops scatter, y: the light that they show
  kDropLight = 7, ///< the place on that light
  // These occur at each surface of a path.
  kScatter = 8,        ///< x: the part of the BSDF that is followed, y: Russian roulette
  kDirection = 9,      ///< the direction of a non-specular ray
  kLightChoice = 10,   ///< x: the light of a light sample
  kLightPoint = 11,    ///< the place on that light
  kMixture = 12,       ///< y: the part of a mixed material; x is not used
  kSplat = 13,         ///< the place in the pixel filter at which a splat falls
  kLobe = 14,          ///< x: the lobe of a rough surface, y: the band by which it scatters
  kSplatRounding = 15, ///< x: whether the film rounds a splat up or down
};

/// The purpose p at the k-th surface of a path is p + k * kPerSurface.
inline constexpr std::uint32_t kPerSurface = 8;

/// A position relative to the pixel's centre, in pixels, for two numbers in [0, 1). Its pdf is the
/// filter.
[[nodiscard]] dvec2 filter_offset(PixelFilter filter, const dvec2& u);

/// The pdf of `filter_offset` in one coordinate, per pixel.
[[nodiscard]] double filter_pdf(PixelFilter filter, double offset);

/// How far from the pixel's centre the filter reaches, in pixels.
[[nodiscard]] double filter_radius(PixelFilter filter);

} // namespace abbe
