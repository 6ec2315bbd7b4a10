#pragma once

#include "core/scene/display_settings.h"

namespace abbe {

[[nodiscard]] DisplayEncoding encoding_of(const DisplaySettings& settings);

/// Takes colours to a display: exposure, adaptation, matrix, tone curve, gamut, transfer function.
class DisplayTransform {
public:
  /// Throws std::invalid_argument for a white point that cannot be white.
  DisplayTransform(const DisplaySettings& settings, Observer observer);

  /// Linear light of the display's primaries, as it is: components may be below 0 or above 1.
  [[nodiscard]] LinearRgb unclipped(const Xyz& color) const;
  /// The same, brought into the display's gamut.
  [[nodiscard]] LinearRgb linear(const Xyz& color) const;
  [[nodiscard]] DisplayRgb encoded(const LinearRgb& linear) const;

private:
  GamutMapping gamut_;
  ToneCurve tone_;
  TransferFunction transfer_;
  Matrix3 to_rgb_;
  Vector3 luminance_weights_;
};

} // namespace abbe
