#pragma once

#include <stdexcept>

namespace abbe {

/// The range of wavelengths the renderer carries, in nm: 405 nm, the 81 cells of 5 nm around the
/// thesis's samples at 380, 385 ... 780 nm.
inline constexpr double kLowerNm = 377.5;
inline constexpr double kUpperNm = 782.5;

/// The thesis's samples [War05]: sample k stands for the mean over the 5 nm around 380 + 5k.
inline constexpr int kSampleCount = 81;
inline constexpr double kFirstSampleNm = 380.0;
inline constexpr double kSampleStepNm = 5.0;

/// Wavelength of sample `index` (0..80), in nm.
[[nodiscard]] constexpr double sample_nm(int index) {
  return kFirstSampleNm + kSampleStepNm * index;
}

/// Cuts 377.5-782.5 nm into `count` bands of equal width. The thesis's levels are 1, 3, 9, 27 and
/// 81 bands; any count from 1 to 405 is valid.
class BandGrid {
public:
  static constexpr int kMaxCount = 405;

  /// Throws std::invalid_argument unless 1 <= count <= 405.
  explicit constexpr BandGrid(int count) : count_(count) {
    if (count < 1 || count > kMaxCount)
      throw std::invalid_argument("the number of bands must be from 1 to 405");
  }

  [[nodiscard]] constexpr int count() const { return count_; }
  [[nodiscard]] constexpr double width_nm() const { return (kUpperNm - kLowerNm) / count_; }

  /// Lower edge of `band`, in nm; `lower_nm(count())` is the upper edge of the last band.
  [[nodiscard]] constexpr double lower_nm(int band) const { return wavelength_nm(band, 0.0); }
  [[nodiscard]] constexpr double center_nm(int band) const { return wavelength_nm(band, 0.5); }

  /// The wavelength, in nm, at the fraction `offset` (0..1) of the width of `band`.
  [[nodiscard]] constexpr double wavelength_nm(int band, double offset) const {
    // One division at the end keeps the edges and centres that are binary fractions exact.
    return kLowerNm + (band + offset) * (kUpperNm - kLowerNm) / count_;
  }

  /// The band that holds `lambda_nm`; the first or last for what lies outside.
  [[nodiscard]] constexpr int band_of(double lambda_nm) const {
    const double place = (lambda_nm - kLowerNm) * count_ / (kUpperNm - kLowerNm);
    if (!(place > 0.0)) return 0;
    return place >= count_ ? count_ - 1 : static_cast<int>(place);
  }

  friend constexpr bool operator==(const BandGrid&, const BandGrid&) = default;

private:
  int count_;
};

} // namespace abbe
