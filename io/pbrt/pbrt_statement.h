#pragma once

#include "io/pbrt/pbrt_state.h"
#include "io/text/numbers.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace abbe {

/// Where a directive stands, and the tokens behind it.
struct Statement {
  PbrtState& state;
  PbrtTokens& tokens;
  SourcePosition where;
  std::size_t nesting; ///< how many files include this one

  [[nodiscard]] double number() const {
    const PbrtToken token = tokens.next();
    if (const auto value = parse_finite(token.text); value && token.kind == PbrtTokenKind::word)
      return *value;
    throw ReadError(tokens.where(token),
                    fmt::format("\"{}\" stands where a number should", token.text),
                    "a transform takes numbers", "Check the directive");
  }
  /// As many numbers, in brackets or not.
  template <std::size_t n>
  [[nodiscard]] std::array<double, n> numbers() const {
    const bool brackets = tokens.peek().kind == PbrtTokenKind::open_bracket;
    if (brackets) (void)tokens.next();
    std::array<double, n> found{};
    for (double& value : found)
      value = number();
    if (brackets && tokens.next().kind != PbrtTokenKind::close_bracket)
      throw ReadError(where, "a closing bracket is missing", fmt::format("{} numbers are read", n),
                      "Add it");
    return found;
  }
  [[nodiscard]] std::string string() const {
    const PbrtToken token = tokens.next();
    if (token.kind == PbrtTokenKind::quoted) return std::string(token.text);
    throw ReadError(tokens.where(token),
                    fmt::format("\"{}\" stands where a string should", token.text),
                    "strings are in quotes", "Check the directive");
  }
};

/// When a directive may stand.
enum class Part : std::uint8_t { options, world, anywhere };

struct Directive {
  std::string_view name;
  void (*read)(const Statement&);
  Part part = Part::anywhere;
};

/// Directives that change the current transform, and those about the picture as a whole.
[[nodiscard]] std::span<const Directive> pbrt_transforms();
[[nodiscard]] std::span<const Directive> pbrt_options();

} // namespace abbe
