#pragma once

#include "spectral/color_space.h"
#include "spectral/curve.h"
#include "spectral/gamut.h"
#include "spectral/observer.h"

#include <optional>

namespace abbe {

/// What shall look white. A light's chromaticity is another for each observer.
struct WhitePoint {
  Chromaticity cie1931_2deg, cie1964_10deg;

  [[nodiscard]] static WhitePoint of_light(const Curve& spectrum);
  [[nodiscard]] const Chromaticity& seen_by(Observer observer) const {
    return observer == Observer::cie1931_2deg ? cie1931_2deg : cie1964_10deg;
  }
  [[nodiscard]] static WhitePoint at(const Chromaticity& c) { return {c, c}; }
  friend bool operator==(const WhitePoint&, const WhitePoint&) = default;
};

/// How a picture is prepared for a screen. None of it touches scene-linear or spectral images.
struct DisplaySettings {
  double exposure_ev = 0.0; ///< brightness is multiplied by 2^exposure
  GamutMapping gamut = GamutMapping::desaturate;
  ColorSpace space = srgb_space();
  std::optional<TransferFunction> transfer = std::nullopt; ///< empty: that of the space
  std::optional<WhitePoint> white_point = std::nullopt;    ///< empty: what is, is shown
};

/// What the numbers of a picture for a screen mean; it goes into the file's colour profile.
struct DisplayEncoding {
  ColorSpace space = srgb_space();
  TransferFunction transfer = srgb_transfer();
  friend bool operator==(const DisplayEncoding&, const DisplayEncoding&) = default;
};

} // namespace abbe
