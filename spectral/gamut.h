#pragma once

#include "spectral/color.h"

#include <cstdint>

namespace abbe {

/// How a colour that the display cannot show is brought to one that it can.
enum class GamutMapping : std::uint8_t {
  clip,       ///< each component by itself to 0..1; changes hue and luminance
  scale,      ///< the thesis's: shifted until none is negative, divided by the range [War05]
  desaturate, ///< toward the grey of equal luminance, only as far as needed
  none,       ///< not at all: what a file of whole numbers cannot hold is clipped as it is written
};

/// The colour with all components in 0..1, but for the mapping `none`. A colour inside the gamut is
/// returned unchanged.
///
/// `desaturate` keeps the luminance Y = weights . rgb and the dominant wavelength: the result is
/// Y + t (rgb - Y) with the largest t <= 1 that fits, so its chromaticity lies on the straight line
/// from the display's white to that of the colour; Y >= 1 gives white, Y <= 0 black.
/// `scale` gives (rgb - low) / (high - low) with low = min(0, rgb) and high = max(1, rgb). It keeps
/// the order of the components and their ratios of differences, that is the hue angle about grey.
///
/// `luminance_weights` are the parts of r, g and b in Y, the second row of rgb_to_xyz_matrix.
[[nodiscard]] LinearRgb map_to_gamut(const LinearRgb& color, GamutMapping mapping,
                                     const Vector3& luminance_weights);

} // namespace abbe
