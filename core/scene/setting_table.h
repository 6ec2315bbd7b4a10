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

// Every setting of an image is one row of the two tables below. The reader of scenes, the command
// line with its help, the metadata of image files and the variations of the bench all use these
// rows, so that none of them can forget a setting or state another default.

/// A value of a setting and the word for it.
template <class Value>
struct Word {
  std::string_view word;
  Value value;
  std::string_view short_word{}; ///< also understood, but not in scenes
};

// The types of values. Each tells where its value lies.

template <class Settings>
struct WholeNumber {
  int Settings::* member;
  Range range;
};
template <class Settings>
struct RealNumber {
  double Settings::* member;
  Range range;
};
/// Any whole number of 64 bits without sign.
struct SeedNumber {
  std::uint64_t RenderSettings::* member;
};
/// One of a few words.
template <class Settings, class Value>
struct Choice {
  Value Settings::* member;
  std::span<const Word<Value>> words;
};
/// The width and height of the whole image.
struct ImageSize {
  Range range;
};
/// The corners of the crop, if there is one.
struct CropCorners {
  Range range;
};
/// Layers by their names, with commas between.
struct LayerNames {};
/// The display's colour space by its name.
struct DisplaySpace {};
/// The display's transfer function by its name or its gamma.
struct DisplayTransfer {};
/// The white point: an illuminant, a chromaticity, or nothing.
struct DisplayWhite {};

template <class Value>
using RenderChoice = Choice<RenderSettings, Value>;

using RenderValue =
    std::variant<WholeNumber<RenderSettings>, RealNumber<RenderSettings>, SeedNumber, ImageSize,
                 CropCorners, RenderChoice<bool>, RenderChoice<Integrator>,
                 RenderChoice<PixelFilter>, RenderChoice<ShadowRule>, RenderChoice<Caustics>,
                 RenderChoice<Observer>, RenderChoice<AdaptiveSampling>, RenderChoice<Tracing>,
                 RenderChoice<Skips>, RenderChoice<Sky>, LayerNames>;
using DisplayValue =
    std::variant<RealNumber<DisplaySettings>, Choice<DisplaySettings, GamutMapping>,
                 Choice<DisplaySettings, AdaptationMethod>, Choice<DisplaySettings, ToneCurve>,
                 DisplaySpace, DisplayTransfer, DisplayWhite>;

/// One setting. Where a name is empty, the setting cannot be given there.
template <class Settings, class Value>
struct SettingRow {
  Value value;
  std::string_view keyword{};   ///< of the scene language
  std::string_view arguments{}; ///< of the keyword; empty for a choice: its words
  std::string_view option{};    ///< of the command line, with its dashes
  std::string_view type{};      ///< of the option's value; empty: by the kind of the value
  std::string_view help{};
  std::string_view default_words{}; ///< describes a default that the value itself does not tell
  std::string_view metadata{};      ///< its name in image files, after the prefix "abbe/"
  std::string_view variation{};     ///< of the bench
  bool flag = false;                ///< the option stands alone and means "on"
  /// Tells whether the setting has an effect. Where it has none, image files leave it out. Null:
  /// always.
  bool (*matters)(const Settings&) = nullptr;
};

using RenderSetting = SettingRow<RenderSettings, RenderValue>;
using DisplaySetting = SettingRow<DisplaySettings, DisplayValue>;

/// All members of RenderSettings, in the order of the help and of image files.
[[nodiscard]] std::span<const RenderSetting> render_setting_table();
/// All members of DisplaySettings.
[[nodiscard]] std::span<const DisplaySetting> display_setting_table();

/// The value as scenes, command lines and image files have it: "81", "on", "512x512". A crop or a
/// white point that is not set is "none".
[[nodiscard]] std::string value_text(const RenderSetting& row, const RenderSettings& settings);
/// A colour space or a transfer function gives its own name, which may differ from the name by
/// which it was found. A transfer function that is not set is that of the space.
[[nodiscard]] std::string value_text(const DisplaySetting& row, const DisplaySettings& settings);

/// All words of a choice, such as "whitted|path"; empty for other settings.
[[nodiscard]] std::string choice_words(const RenderSetting& row);
[[nodiscard]] std::string choice_words(const DisplaySetting& row);

} // namespace abbe
