#pragma once

#include "core/image/image.h"

namespace abbe {

// Pictures, or rows of them, brought to another window. What lies outside their own is 0: black and
// clear.

[[nodiscard]] SceneLinearImage placed_in(const PixelWindow& frame, const SceneLinearImage& image);
[[nodiscard]] SpectralImage placed_in(const PixelWindow& frame, const SpectralImage& image);
/// Over the whole of its display window.
[[nodiscard]] DisplayImage in_full_frame(const DisplayImage& image);

/// What two windows have in common, if that is any pixel.
[[nodiscard]] std::optional<PixelWindow> common_part(const PixelWindow& a, const PixelWindow& b);

} // namespace abbe
