#include "bench/measurements/variation.h"

#include "core/scene/user_error.h"
#include "io/settings/setting_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe::bench {
namespace {

void apply(std::string_view word, RenderSettings& settings) {
  if (word == "default") return;
  const std::size_t equals = word.find('=');
  const auto table = render_setting_table();
  const auto row = std::ranges::find(table, word.substr(0, equals), &RenderSetting::variation);
  if (word.empty() || row == table.end() || (equals == word.npos && !row->flag))
    throw UserError(
        fmt::format("\"{}\" is no variation; these are: {} or default", word, variation_words()));
  set_from_text(*row, equals == word.npos ? "on" : word.substr(equals + 1), settings);
}

} // namespace

std::string variation_words() {
  std::string list;
  for (const RenderSetting& row : render_setting_table()) {
    if (row.variation.empty()) continue;
    const std::string words = choice_words(row);
    list += fmt::format("{}{}", list.empty() ? "" : ", ", row.variation);
    if (!row.flag) list += fmt::format("={}", words.empty() ? std::string(row.arguments) : words);
  }
  return list;
}

Variation parse_variation(std::string_view text, const RenderSettings& settings) {
  Variation variation{std::string(text), settings};
  while (true) {
    const std::size_t comma = text.find(',');
    apply(text.substr(0, comma), variation.settings);
    if (comma == text.npos) return variation;
    text.remove_prefix(comma + 1);
  }
}

} // namespace abbe::bench
