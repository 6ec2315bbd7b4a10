#pragma once

#include "spectral/band_grid.h"
#include "spectral/curve.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace abbe {

/// Band arrays are padded to a multiple of this many floats, so that loops run in whole registers.
inline constexpr std::size_t kBandPadding = 16;

[[nodiscard]] constexpr std::size_t padded_band_count(int bands) {
  return (static_cast<std::size_t>(bands) + kBandPadding - 1) / kBandPadding * kBandPadding;
}

/// The values of a curve at the bands of a grid. A table of one value knows that, so that loops
/// need not look it up.
class BandTable {
public:
  BandTable() : BandTable(0.0f, 0) {}
  /// The same value in every band.
  BandTable(float constant, int bands)
      : values_(padded_band_count(bands), constant), constant_(constant), zero_(constant == 0.0f) {}
  /// One value per band.
  explicit BandTable(const std::vector<double>& values);
  /// The curve's value at every band's centre. With `keep_constant` off a constant curve is stored
  /// like any other.
  [[nodiscard]] static BandTable at_centers(const BandGrid& grid, const Curve& curve,
                                            bool keep_constant);

  /// The curve's value at given wavelengths, one per band.
  [[nodiscard]] static BandTable at_wavelengths(const std::vector<double>& nm, const Curve& curve,
                                                bool keep_constant);

  /// A copy with a number added in each of the bands.
  [[nodiscard]] BandTable plus(float addend, int bands) const;

  [[nodiscard]] bool zero() const { return zero_; }
  [[nodiscard]] std::optional<float> constant() const { return constant_; }
  [[nodiscard]] float operator[](int band) const { return values_[static_cast<std::size_t>(band)]; }
  [[nodiscard]] const float* data() const { return values_.data(); }

  /// The values, to be overwritten. From then on the table counts as one that varies.
  [[nodiscard]] float* varying() {
    constant_.reset();
    zero_ = false;
    return values_.data();
  }

private:
  std::vector<float> values_;
  std::optional<float> constant_;
  bool zero_ = false;
};

/// The strength of a spectrum, for choosing between lights: its mean over the bands. Bands that the
/// eye hardly sees count as much as others, since they are light too.
[[nodiscard]] double band_mean(const Curve& spectrum, const BandGrid& grid);

} // namespace abbe
