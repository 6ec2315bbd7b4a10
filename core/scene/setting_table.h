#pragma once

#include "core/scene/display_settings.h"
#include "core/scene/number_range.h"
#include "core/scene/settings.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace abbe {

// Every setting of a picture is one row of the two tables below. The reader of scenes, the command
// line and its help, the text in picture files and the variations of the bench all take it from
// there, so that none of them can forget a setting or tell another default.

/// A value of a setting by its word.
template <class Value>
struct Word {
  std::string_view word;
  Value value;
  std::string_view short_word{}; ///< also taken, but not in scenes
};

// What a setting's value is and where it lies.

template <class Settings>
struct WholeNumber {
  int Settings::*member;
  Range range;
};
template <class Settings>
struct RealNumber {
  double Settings::*member;
  Range range;
};
/// Any whole number of 64 bits.
struct SeedNumber {
  std::uint64_t RenderSettings::*member;
};
/// One of a few words.
template <class Settings, class Value>
struct Choice {
  Value Settings::*member;
  std::span<const Word<Value>> words;
};
/// Width and height of the whole picture.
struct ImageSize {
  Range range;
};
/// The corners of the crop, if there is one.
struct CropCorners {
  Range range;
};
/// The display's colour space by its name.
struct DisplaySpace {};
/// The display's transfer function by its name or its gamma.
struct DisplayTransfer {};
/// What shall look white: an illuminant, a chromaticity, or nothing.
struct DisplayWhite {};

template <class Value>
using RenderChoice = Choice<RenderSettings, Value>;

using RenderValue =
    std::variant<WholeNumber<RenderSettings>, RealNumber<RenderSettings>, SeedNumber, ImageSize,
                 CropCorners, RenderChoice<bool>, RenderChoice<Integrator>,
                 RenderChoice<PixelFilter>, RenderChoice<ShadowRule>, RenderChoice<Caustics>,
                 RenderChoice<Observer>, RenderChoice<AdaptiveSampling>, RenderChoice<Tracing>,
                 RenderChoice<Skips>>;
using DisplayValue =
    std::variant<RealNumber<DisplaySettings>, Choice<DisplaySettings, GamutMapping>, DisplaySpace,
                 DisplayTransfer, DisplayWhite>;

/// One setting. A name that is empty says that the setting is not to be had in that way.
template <class Settings, class Value>
struct SettingRow {
  Value value;
  std::string_view keyword{};   ///< of the scene language
  std::string_view arguments{}; ///< of the keyword; empty for a choice: its words
  std::string_view option{};    ///< of the command line, with its dashes
  std::string_view type{};      ///< of the option's value; empty: by the kind of the value
  std::string_view help{};
  std::string_view default_words{}; ///< the default in words, where its value does not tell it
  std::string_view metadata{};      ///< in picture files, where it gets the prefix "abbe/"
  std::string_view variation{};     ///< of the bench
  bool flag = false;                ///< the option stands alone and means "on"
  /// Whether it can make a difference; where not, it is left out of picture files. Null: always.
  bool (*matters)(const Settings&) = nullptr;
};

using RenderSetting = SettingRow<RenderSettings, RenderValue>;
using DisplaySetting = SettingRow<DisplaySettings, DisplayValue>;

/// All members of RenderSettings, in the order of the help and of picture files.
[[nodiscard]] std::span<const RenderSetting> render_setting_table();
/// All members of DisplaySettings.
[[nodiscard]] std::span<const DisplaySetting> display_setting_table();

/// The value as scenes, command lines and picture files have it: "81", "on", "512x512". A crop or a
/// white point that is not set is "none".
[[nodiscard]] std::string value_text(const RenderSetting& row, const RenderSettings& settings);
/// The name of a colour space or a transfer function is its own, which is not always that by which
/// it is found; a transfer function that is not set is that of the space.
[[nodiscard]] std::string value_text(const DisplaySetting& row, const DisplaySettings& settings);

/// "whitted|path": all words of a choice; empty for other settings.
[[nodiscard]] std::string choice_words(const RenderSetting& row);
[[nodiscard]] std::string choice_words(const DisplaySetting& row);

} // namespace abbe
