#pragma once

#include "core/image/display.h"

#include <optional>
#include <string_view>

namespace abbe {

/// A white point in one word: the name of an illuminant, or x,y. "none" gives an empty white point,
/// anything else an empty result.
[[nodiscard]] std::optional<std::optional<WhitePoint>> parse_white_point(std::string_view text);

/// True for chromaticities that an eye can take for white: those that can be adapted to another.
[[nodiscard]] bool can_be_white(const Chromaticity& c);

} // namespace abbe
