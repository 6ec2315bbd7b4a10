#pragma once

#include "core/scene/display_settings.h"

namespace abbe {

[[nodiscard]] DisplayEncoding encoding_of(const DisplaySettings& settings);

/// Takes colours to a display: exposure, adaptation, matrix, gamut, transfer function.
class DisplayTransform {
public:
  /// Throws std::invalid_argument for a white point that cannot be white.
  DisplayTransform(const DisplaySettings& settings, Observer observer);

  /// Linear light of the display's primaries, in gamut.
  [[nodiscard]] LinearRgb linear(const Xyz& color) const;
  [[nodiscard]] DisplayRgb encoded(const LinearRgb& linear) const;

private:
  GamutMapping gamut_;
  TransferFunction transfer_;
  Matrix3 to_rgb_;
  Vector3 luminance_weights_;
};

} // namespace abbe
