#include "io/text/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace abbe {
namespace {

/// The value of the whole text, which may begin with a plus sign.
template <class Number>
std::optional<Number> parse_whole_text(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

} // namespace

std::optional<double> parse_finite(std::string_view text) {
  const auto value = parse_whole_text<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parse_whole(std::string_view text) {
  return parse_whole_text<std::int64_t>(text);
}

std::optional<std::uint64_t> parse_seed(std::string_view text) {
  return parse_whole_text<std::uint64_t>(text);
}

std::string words(const Range& range) {
  if (std::isinf(range.highest))
    return fmt::format("{}{}", range.open ? "more than " : "", range.lowest) +
           (range.open ? "" : " or more");
  return range.open ? fmt::format("more than {} and less than {}", range.lowest, range.highest)
                    : fmt::format("from {} to {}", range.lowest, range.highest);
}

} // namespace abbe
