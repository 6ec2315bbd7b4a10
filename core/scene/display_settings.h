#pragma once

#include "spectral/adaptation.h"
#include "spectral/color_space.h"
#include "spectral/curve.h"
#include "spectral/gamut.h"
#include "spectral/observer.h"
#include "spectral/tone_curve.h"

#include <optional>

namespace abbe {

/// The chromaticity that is shown as white. That of a light differs between the observers.
struct WhitePoint {
  Chromaticity cie1931_2deg, cie1964_10deg;

  [[nodiscard]] static WhitePoint of_light(const Curve& spectrum);
  [[nodiscard]] const Chromaticity& seen_by(Observer observer) const {
    return observer == Observer::cie1931_2deg ? cie1931_2deg : cie1964_10deg;
  }
  [[nodiscard]] static WhitePoint at(const Chromaticity& c) { return {c, c}; }
  friend bool operator==(const WhitePoint&, const WhitePoint&) = default;
};

/// How an image is prepared for a screen. Scene-linear and spectral images do not depend on it.
struct DisplaySettings {
  double exposure_ev = 0.0; ///< radiance is multiplied by 2^exposure_ev
  GamutMapping gamut = GamutMapping::desaturate;
  ColorSpace space = srgb_space();
  std::optional<TransferFunction> transfer = std::nullopt;  ///< empty: that of the space
  std::optional<WhitePoint> white_point = std::nullopt;     ///< empty: no adaptation
  AdaptationMethod adaptation = AdaptationMethod::bradford; ///< to the white point
  ToneCurve tone = ToneCurve::linear;
};

/// What the numbers of an image for a screen mean. The file's colour profile is made from it.
struct DisplayEncoding {
  ColorSpace space = srgb_space();
  TransferFunction transfer = srgb_transfer();
  friend bool operator==(const DisplayEncoding&, const DisplayEncoding&) = default;
};

} // namespace abbe
