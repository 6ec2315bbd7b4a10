#pragma once

#include "core/scene/setting_table.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// Gives a setting the value that a text tells, in the words of the command line. Throws UserError,
/// which says what would be right.
void set_from_text(const RenderSetting& row, std::string_view text, RenderSettings& settings);
void set_from_text(const DisplaySetting& row, std::string_view text, DisplaySettings& settings);

/// What the setting's text may be: "a whole number from 1 to 405".
[[nodiscard]] std::string right_text(const RenderSetting& row);
[[nodiscard]] std::string right_text(const DisplaySetting& row);

/// A setting and the text that gives its value.
template <class Row>
struct GivenSetting {
  const Row* row;
  std::string text;
};

/// Settings given beside a scene, in the order given; each replaces the scene's.
using SettingsOverride = std::vector<GivenSetting<RenderSetting>>;
using DisplayOverride = std::vector<GivenSetting<DisplaySetting>>;

/// The scene's settings with those given in their place.
[[nodiscard]] RenderSettings overridden(RenderSettings scene, const SettingsOverride& given);
[[nodiscard]] DisplaySettings overridden(DisplaySettings scene, const DisplayOverride& given);

/// The row of an option of the command line. There must be one.
[[nodiscard]] const RenderSetting& setting_of_option(std::string_view option);

} // namespace abbe
