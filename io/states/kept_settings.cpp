#include "io/states/kept_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace abbe {
namespace {

/// No byte of a picture depends on these, or on when the rendering is stopped.
constexpr std::array<std::string_view, 5> kNotKept{"--spp", "--time", "--threads", "--skip",
                                                   "--tracing"};

bool is_kept(const RenderSetting& row) {
  return !row.option.empty() && std::ranges::find(kNotKept, row.option) == kNotKept.end();
}

} // namespace

KeptSettings kept_settings(const RenderSettings& settings) {
  KeptSettings kept;
  for (const RenderSetting& row : render_setting_table())
    if (is_kept(row)) kept.emplace_back(row.option, value_text(row, settings));
  return kept;
}

RenderSettings with_kept(RenderSettings settings, const KeptSettings& kept,
                         const SettingsOverride& given) {
  for (const RenderSetting& row : render_setting_table()) {
    const auto same = [&](const auto& other) { return other.row == &row; };
    if (!is_kept(row) || std::ranges::any_of(given, same)) continue;
    for (const auto& [option, value] : kept)
      if (option == row.option && value != value_text(row, settings))
        set_from_text(row, value, settings);
  }
  return settings;
}

std::string difference(const KeptSettings& kept, const RenderSettings& settings) {
  std::string text;
  for (const auto& [option, value] : kept_settings(settings)) {
    const auto old = std::ranges::find(kept, option, &KeptSettings::value_type::first);
    const std::string before = old == kept.end() ? "nothing" : old->second;
    if (before != value)
      text += fmt::format("{}{} {}, not {}", text.empty() ? "" : "; ", option, value, before);
  }
  return text;
}

} // namespace abbe
