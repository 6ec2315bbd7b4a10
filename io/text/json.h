#pragma once

#include <span>
#include <string>
#include <string_view>

namespace abbe {

/// The text as a string of JSON, with its quotes.
[[nodiscard]] std::string json_string(std::string_view text);

/// The number as JSON has it, to 12 digits; null for what JSON has no number for.
[[nodiscard]] std::string json_number(double value);

/// The numbers as an array of JSON.
[[nodiscard]] std::string json_list(std::span<const double> values);

} // namespace abbe
