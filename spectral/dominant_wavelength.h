#pragma once

#include "spectral/color.h"
#include "spectral/observer.h"

#include <optional>

namespace abbe {

/// The light of one wavelength that makes a colour when it is mixed with white.
struct DominantWavelength {
  double nm = 0.0;
  /// True for purples, which no single wavelength makes: with light of `nm`, which lies on the
  /// other side of the white, the colour makes the white.
  bool complementary = false;
  /// Distance of the colour from the white in x, y over that of the boundary of all colours in the
  /// same direction: 0 for white, 1 for light of one wavelength.
  double purity = 0.0;
};

/// By the observer's values at each nm from 380 to 780, where the boundary is straight between two
/// of them [CIE15, 9.1]. Empty for the white itself, and for a chromaticity that has no numbers.
[[nodiscard]] std::optional<DominantWavelength>
dominant_wavelength(const Chromaticity& c, const Chromaticity& white,
                    Observer observer = Observer::cie1931_2deg);

} // namespace abbe
