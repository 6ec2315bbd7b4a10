// Arguments stand after their keyword, separated by white space:
//
//   translate 1 -0.5 +2e3
//   UseMaterial "lead crystal"
//   jitter off

#include "io/text/read_arguments.h"

#include <fmt/format.h>

namespace abbe {

bool Arguments::number_follows() const {
  const Token& token = reader_.peek();
  return token.kind == TokenKind::word && parse_finite(token.text).has_value();
}

Token Arguments::number_token(std::string_view kind) {
  const Token& token = reader_.peek();
  if (token.kind == TokenKind::end)
    throw ReadError(token.where, fmt::format("{} ends where {} should stand", ending(token), kind),
                    takes(), "Complete the statement");
  if (token.kind != TokenKind::word)
    throw ReadError(token.where, fmt::format("{} is not {}", shown(token), kind), takes(),
                    fmt::format("Give {} without quotes and braces", kind));
  return reader_.next();
}

double Arguments::number() {
  const Token token = number_token("a number");
  const auto value = parse_finite(token.text);
  if (!value)
    throw ReadError(token.where, shown(token) + " is not a number", takes(),
                    "Give a finite number such as 2, -0.5 or 1e-3");
  return *value;
}

double Arguments::number(const Range& range) {
  const Token token = reader_.peek();
  const double value = number();
  if (!range.holds(value)) fail_range(token, range);
  return value;
}

glm::dvec3 Arguments::vector() {
  const double x = number();
  const double y = number();
  return {x, y, number()};
}

std::int64_t Arguments::whole_number(const Range& range) {
  const Token token = number_token("a whole number");
  const auto value = parse_whole(token.text);
  if (!value)
    throw ReadError(token.where, shown(token) + " is not a whole number", takes(),
                    "Give digits only, such as 81");
  if (!range.holds(static_cast<double>(*value))) fail_range(token, range);
  return *value;
}

std::uint64_t Arguments::seed() {
  const Token token = number_token("a whole number");
  const auto value = parse_seed(token.text);
  if (!value)
    throw ReadError(token.where, shown(token) + " is not a seed", takes(),
                    "Give a whole number from 0 to 18446744073709551615");
  return *value;
}

bool Arguments::on_off() {
  return choice<bool>({{"on", true}, {"off", false}});
}

Token Arguments::name_token(std::string_view meaning) {
  const Token& token = reader_.peek();
  if ((token.kind != TokenKind::word && token.kind != TokenKind::quoted) || token.text.empty())
    throw ReadError(token.where, fmt::format("{} stands where {} should", shown(token), meaning),
                    takes(), "Give a name; one with spaces goes in double quotes");
  return reader_.next();
}

std::string Arguments::takes() const {
  const std::size_t space = usage_.find(' ');
  return fmt::format("{} takes {}", name(),
                     space == std::string_view::npos ? "no arguments" : usage_.substr(space + 1));
}

std::size_t Arguments::chosen(const std::vector<std::string>& names) {
  const Token& token = reader_.peek();
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const std::string& name) { return is_word(token, name); });
  if (found == names.end()) {
    std::string list = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
      list += (i + 1 == names.size() ? " or " : ", ") + names[i];
    throw ReadError(token.where, fmt::format("{} is no choice of {}", shown(token), name()),
                    takes(), "Give " + list);
  }
  reader_.next();
  return static_cast<std::size_t>(found - names.begin());
}

void Arguments::fail_range(const Token& token, const Range& range) const {
  throw ReadError(token.where, fmt::format("{} is out of range for {}", token.text, name()),
                  fmt::format("it is {}", range.meaning), "Give a number " + words(range));
}

} // namespace abbe
