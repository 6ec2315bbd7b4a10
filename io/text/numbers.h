#pragma once

#include "core/scene/number_range.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace abbe {

// Numbers are decimal, with or without a sign. Each is the number that the whole text is; empty for
// anything else.

/// A finite number.
[[nodiscard]] std::optional<double> parse_finite(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> parse_whole(std::string_view text);
[[nodiscard]] std::optional<std::uint64_t> parse_seed(std::string_view text);

/// "from 1 to 405", "more than 0": the numbers of a range in words.
[[nodiscard]] std::string words(const Range& range);

} // namespace abbe
