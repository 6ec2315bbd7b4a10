#pragma once

#include "core/image/display.h"
#include "core/image/image.h"

#include <span>

namespace abbe {

// Pictures of colours that are there already, from the upper left pixel of `data` on, by the same
// transforms as those of a rendering.

/// Scene-linear, opaque.
[[nodiscard]] SceneLinearImage scene_linear_of(const PixelWindow& display, const PixelWindow& data,
                                               std::span<const Xyz> colors, SceneLinearSpace space);

/// For a screen. Throws std::invalid_argument for a white point that cannot be white.
[[nodiscard]] DisplayImage display_of(const PixelWindow& display, const PixelWindow& data,
                                      std::span<const Xyz> colors, const DisplaySettings& settings,
                                      Observer observer);

} // namespace abbe
