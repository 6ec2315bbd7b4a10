#pragma once

#include "core/film/file_backed_sums.h"
#include "core/scene/pixel_window.h"
#include "spectral/color.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace abbe {

/// Where a film keeps the sums of bands: more than `largest_in_memory` bytes of them in a file in
/// `folder`, unless that is empty.
struct BandPlace {
  std::filesystem::path folder = {};
  std::size_t largest_in_memory = std::size_t{512} << 20;
};

/// Sums of camera samples. They are integers, multiples of a power-of-two quantum, so their value
/// does not depend on the order in which threads add.
class Film {
public:
  /// `bands` is 0 for XYZ alone, else the number of bands whose sums are kept too, 8 bytes more per
  /// pixel and band. With `keep_errors` the film keeps what `error` needs, 24 bytes more per pixel
  /// besides its 44. Errors: those of FileBackedSums.
  Film(PixelWindow window, double quantum, int bands, bool keep_errors = false,
       BandPlace place = {});

  /// Adds one sample of a pixel inside the window; those of a pixel come in the sampler's order.
  /// `radiance` holds one value per band when the film keeps bands. Values that are not finite,
  /// negative ones and overflows are counted and left out: they add nothing, though their sample
  /// counts. One pixel must not be added to by two threads at once.
  void add(int x, int y, const Xyz& color, bool covered, std::span<const float> radiance);

  /// Tells that so many pixels' bands were added to or read, so that a file's do not fill the
  /// memory. Any number of threads may tell.
  void touched_bands(std::size_t pixels) const {
    band_sums_.touched(pixels * static_cast<std::size_t>(bands_));
  }

  /// Makes room for splats.
  void enable_splats();
  /// Adds what a light path brings to a pixel inside the window, as a mean over the light paths of
  /// one pass. Any number of threads may add at once. The random number `u` in [0, 1) rounds it up
  /// or down, so that the mean is right for splats that are much smaller than the quantum.
  void add_splat(int x, int y, const Xyz& color, std::span<const float> radiance, double u);
  /// Counts the light paths whose splats were added, in passes.
  void add_light_passes(double passes) { light_passes_ += passes; }

  [[nodiscard]] const PixelWindow& window() const { return window_; }
  [[nodiscard]] int bands() const { return bands_; }

  // Means over the samples of a pixel, and splats over the light passes; 0 where there is none.
  [[nodiscard]] Xyz color(int x, int y) const;
  [[nodiscard]] double alpha(int x, int y) const;
  [[nodiscard]] double radiance(int x, int y, int band) const;
  [[nodiscard]] bool keeps_errors() const { return !first_sums_.empty(); }
  /// The standard error of `color`, estimated from the difference of two parts of the pixel's n
  /// samples: the first a, where a is the largest power of two below n, and the other b = n - a.
  /// For parts with means A and B it is sqrt(a b) / n |A - B|, half the difference of equal halves.
  /// Infinite with fewer than two samples. One degree of freedom: good in the mean over many
  /// pixels only. The film must keep errors.
  ///
  /// Such parts, and not odd and even samples, are each as evenly spread as the sampler's
  /// sequences are [Burley20]; docs/decisions/noise.md tells how much too large that is.
  [[nodiscard]] Xyz error(int x, int y) const;
  /// The same with the sign of A - B, so that it is linear in the samples: its linear R, G, B are
  /// those of the pixel's error.
  [[nodiscard]] Xyz signed_error(int x, int y) const;
  [[nodiscard]] std::uint32_t samples(int x, int y) const { return counts_[index(x, y)]; }

  /// Samples that were refused.
  struct Refused {
    std::uint64_t not_finite = 0, negative = 0, overflow = 0;
  };
  [[nodiscard]] Refused refused() const;

private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - window_.y0) * static_cast<std::size_t>(window_.width()) +
           static_cast<std::size_t>(x - window_.x0);
  }
  /// True when the value can be summed; else the pixel's tally of refused samples grows.
  bool accept(double value, std::size_t pixel);
  void sum(std::int64_t& total, double value, std::size_t pixel);
  void splat(std::int64_t& total, double value, double u);
  [[nodiscard]] double mean(std::int64_t sum, std::size_t pixel) const;
  /// Entry `i` of splats, as a mean; 0 where there are none.
  template <class Sums>
  [[nodiscard]] double splat_mean(const Sums& splats, std::size_t i) const {
    return splats.empty() || light_passes_ == 0.0
               ? 0.0
               : static_cast<double>(splats[i]) * quantum_ / light_passes_;
  }
  /// Sums of all bands of all pixels.
  [[nodiscard]] FileBackedSums make_band_sums() const;

  PixelWindow window_;
  double quantum_;
  int bands_;
  std::vector<std::int64_t> sums_;       ///< X, Y, Z per pixel
  std::vector<std::int64_t> first_sums_; ///< X, Y, Z of the first part of the samples
  BandPlace place_;
  FileBackedSums band_sums_;         ///< per pixel, per band
  std::vector<std::int64_t> splats_; ///< as sums_; empty until asked for
  FileBackedSums band_splats_;       ///< as band_sums_; empty until asked for
  double light_passes_ = 0.0;
  Refused refused_splats_;
  std::vector<std::uint32_t> counts_;                 ///< samples per pixel
  std::vector<std::uint32_t> covered_;                ///< samples that met a surface
  std::vector<std::array<std::uint32_t, 3>> refused_; ///< per pixel, so that threads do not share
};

} // namespace abbe
