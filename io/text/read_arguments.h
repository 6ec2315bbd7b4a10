#pragma once

#include "core/scene/number_range.h"
#include "io/text/numbers.h"
#include "io/text/token.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abbe {

/// Reads the arguments that follow a keyword. Everything throws ReadError at the wrong token.
class Arguments {
public:
  /// `usage` is the keyword and its arguments, as in "translate x y z".
  Arguments(TokenReader& reader, Token keyword, std::string_view usage)
      : reader_(reader), keyword_(std::move(keyword)), usage_(usage) {}

  [[nodiscard]] TokenReader& reader() const { return reader_; }
  [[nodiscard]] const Token& keyword() const { return keyword_; }
  /// The keyword as the documentation writes it.
  [[nodiscard]] std::string_view name() const { return usage_.substr(0, usage_.find(' ')); }

  /// True when the next token is an unquoted number.
  [[nodiscard]] bool number_follows() const;
  double number();
  double number(const Range& range);
  glm::dvec3 vector();
  std::int64_t whole_number(const Range& range);
  std::uint64_t seed();
  bool on_off();

  /// A name: any word, or anything in quotes. `meaning` completes "... where ... should stand".
  Token name_token(std::string_view meaning);

  /// One of several words, in upper or lower case.
  template <class Value>
  Value choice(std::initializer_list<std::pair<std::string_view, Value>> words) {
    std::vector<std::string> names;
    for (const auto& [word, value] : words)
      names.emplace_back(word);
    return (words.begin() + static_cast<std::ptrdiff_t>(chosen(names)))->second;
  }

  /// The number of the word in `names` that follows.
  std::size_t chosen(const std::vector<std::string>& names);

  /// "translate takes x y z"
  [[nodiscard]] std::string takes() const;

private:
  Token number_token(std::string_view kind);
  [[noreturn]] void fail_range(const Token& token, const Range& range) const;

  TokenReader& reader_;
  Token keyword_;
  std::string_view usage_;
};

} // namespace abbe
