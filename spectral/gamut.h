#pragma once

#include "spectral/color.h"

#include <cstdint>

namespace abbe {

/// How a colour that the display cannot show is brought to one that it can.
enum class GamutMapping : std::uint8_t {
  clip,       ///< each component by itself to 0..1; changes hue and luminance
  desaturate, ///< toward the grey of equal luminance, only as far as needed
  // The thesis's shift-and-scale joins here: a name, and a branch in map_to_gamut.
};

/// The colour with all components in 0..1. A colour inside the gamut is returned unchanged.
/// `desaturate` keeps the luminance Y and the direction from grey in linear RGB: the result is
/// Y + t (rgb - Y) with the largest t <= 1 that fits; Y >= 1 gives white, Y <= 0 black.
[[nodiscard]] LinearRgb map_to_gamut(const LinearRgb& color, GamutMapping mapping);

} // namespace abbe
