// Light and material libraries have one shape:
//
//   filter 2a              ! or: def StrongOrangeYellow
//   {
//     intensity 0.85       ! keys in any order, each at most once
//     colour 81 0.000 0.000 ... 0.000
//   }
//   endfilter              ! or: endmaterial; may be left out

#include "io/libraries/read_library.h"

#include "core/scene/quantity_limits.h"
#include "io/text/similar_names.h"
#include "spectral/band_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace abbe {
namespace {

std::string entry_form(const LibraryWords& words) {
  return fmt::format("an entry is {} NAME {{ keys }}", words.begin);
}

std::string key_name(std::string_view usage) {
  return std::string(usage.substr(0, usage.find(' ')));
}

void expect_open_brace(TokenReader& reader, const LibraryWords& words) {
  const Token& token = reader.next();
  if (token.kind != TokenKind::open_brace)
    throw ReadError(token.where, fmt::format("\"{{\" is missing before {}", shown(token)),
                    entry_form(words), "Add it after the name");
}

/// Samples beyond the last: zeros are harmless, anything else shows that the list is not ours.
void skip_surplus(Arguments& arguments, int count, const Warn& warn) {
  const SourcePosition first = arguments.reader().peek().where;
  int surplus = 0;
  for (; arguments.number_follows(); ++surplus) {
    const Token token = arguments.reader().peek();
    if (arguments.number() != 0.0)
      throw ReadError(
          token.where,
          fmt::format("{} is one of too many values for {}", token.text, arguments.name()),
          fmt::format("{} values from 380 to 780 nm are read; only zeros may follow", count),
          "Remove it, or look for one given twice");
  }
  if (surplus > 0 && warn)
    warn(fmt::format("{}: {} zeros after the {} values of {} are left out (they lie beyond 780 nm)",
                     to_string(first), surplus, count, arguments.name()));
}

} // namespace

Curve read_samples(Arguments& arguments, const Warn& warn) {
  const Token at = arguments.reader().peek();
  const auto count = static_cast<int>(arguments.whole_number({"the number of values"}));
  constexpr std::array kCounts{41, kSampleCount, 201, 401};
  if (std::ranges::find(kCounts, count) == kCounts.end())
    throw ReadError(at.where,
                    fmt::format("{} values are announced for {}", at.text, arguments.name()),
                    "libraries hold values from 380 to 780 nm, in steps of 10, 5, 2 or 1 nm",
                    fmt::format("Give {} values, or 41, 201 or 401", kSampleCount));
  const double step = 400.0 / (count - 1);
  std::vector<double> values;
  while (static_cast<int>(values.size()) < count) {
    const Token& token = arguments.reader().peek();
    const std::string place = fmt::format("value {} of {}", values.size() + 1, count);
    const std::string grid = fmt::format("at 380, {:g} ... 780 nm", 380.0 + step);
    if (token.kind != TokenKind::word)
      throw ReadError(token.where,
                      fmt::format("{} has only {} values", arguments.name(), values.size()),
                      fmt::format("{} stands where {} should", shown(token), place),
                      fmt::format("Give {} values, {}", count, grid));
    if (!arguments.number_follows())
      throw ReadError(token.where, shown(token) + " is not a number",
                      "it stands where " + place + " should",
                      fmt::format("Give {} numbers for {}", count, arguments.name()));
    values.push_back(arguments.number({"a share of light, never negative", 0.0, kMostLight}));
  }
  skip_surplus(arguments, count, warn);
  if (count == kSampleCount) return Curve::samples81(std::move(values));
  std::vector<double> nm;
  for (int i = 0; i < count; ++i)
    nm.push_back(380.0 + step * i);
  return Curve::table(std::move(nm), std::move(values));
}

std::optional<Token> read_entry_head(TokenReader& reader, const LibraryWords& words) {
  while (is_word(reader.peek(), words.end))
    reader.next();
  if (reader.at_end()) return std::nullopt;
  const Token keyword = reader.next();
  if (!is_word(keyword, words.begin))
    throw ReadError(keyword.where,
                    fmt::format("{} stands where {} should", shown(keyword), words.begin),
                    entry_form(words), "Check the braces of the entry before it");
  const std::string usage = fmt::format("{} NAME {{ keys }}", words.begin);
  Token name = Arguments(reader, keyword, usage).name_token("a name");
  expect_open_brace(reader, words);
  return name;
}

std::optional<std::size_t> read_key(TokenReader& reader, const LibraryWords& words,
                                    const std::vector<std::string_view>& usages,
                                    const std::vector<bool>& seen) {
  const Token& token = reader.peek();
  if (token.kind == TokenKind::close_brace) {
    reader.next();
    return std::nullopt;
  }
  if (token.kind == TokenKind::end || is_word(token, words.begin) || is_word(token, words.end))
    throw ReadError(token.where, fmt::format("\"}}\" is missing before {}", shown(token)),
                    entry_form(words), "Add it after the last key");
  std::vector<std::string> names;
  for (const std::string_view usage : usages) {
    names.push_back(key_name(usage));
    if (!is_word(token, names.back())) continue;
    const std::size_t row = names.size() - 1;
    if (seen[row])
      throw ReadError(token.where, fmt::format("{} is given twice", names.back()),
                      "an entry has each key at most once", "Remove one of them");
    return row;
  }
  std::string list = "The keys are";
  for (const std::string& name : names)
    list += ' ' + name;
  throw ReadError(token.where, "unknown key " + shown(token),
                  fmt::format("no such key in an entry of {}", words.begin),
                  did_you_mean(token.text, names, list));
}

ReadError duplicate_entry(const Token& name) {
  return {name.where, shown(name) + " is defined twice",
          "names must differ by more than upper and lower case", "Rename or remove one of them"};
}

ReadError missing_key(const Token& name, std::string_view usage) {
  return {name.where, fmt::format("{} has no {}", shown(name), key_name(usage)),
          "nothing sensible can stand in for it", fmt::format("Add {}", usage)};
}

} // namespace abbe
