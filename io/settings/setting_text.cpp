// Settings as words of a command line:
//
//   --bands 27  --size 640x480  --crop 0,0,64,64  --filter tent  --white-point D50

#include "io/settings/setting_text.h"

#include "core/scene/user_error.h"
#include "io/libraries/read_display.h"
#include "io/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

namespace abbe {
namespace {

/// As many whole numbers as there are places, separated by one character.
template <std::size_t count>
std::optional<std::array<int, count>> whole_numbers(std::string_view text, char separator) {
  std::array<int, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t stop = text.find(separator);
    if ((stop == text.npos) != (i + 1 == count)) return std::nullopt;
    const auto value = parse_whole(text.substr(0, stop));
    constexpr std::int64_t kMost = std::numeric_limits<int>::max();
    if (!value || *value > kMost || *value < -kMost) return std::nullopt;
    numbers[i] = static_cast<int>(*value);
    if (stop != text.npos) text.remove_prefix(stop + 1);
  }
  return numbers;
}

/// Sets one kind of value; false where the text is not right for it.
template <class Settings>
struct SetFrom {
  std::string_view text;
  Settings& settings;

  bool operator()(const WholeNumber<Settings>& v) const {
    const auto value = parse_whole(text);
    if (!value || !v.range.holds(static_cast<double>(*value))) return false;
    settings.*v.member = static_cast<int>(*value);
    return true;
  }
  bool operator()(const RealNumber<Settings>& v) const {
    const auto value = parse_finite(text);
    if (!value || !v.range.holds(*value)) return false;
    settings.*v.member = *value;
    return true;
  }
  template <class Value>
  bool operator()(const Choice<Settings, Value>& v) const {
    for (const Word<Value>& word : v.words)
      if (text == word.word || (!text.empty() && text == word.short_word)) {
        settings.*v.member = word.value;
        return true;
      }
    return false;
  }
  bool operator()(const SeedNumber& v) const { return set(parse_seed(text), settings.*v.member); }
  bool operator()(const ImageSize& v) const {
    const auto sides = whole_numbers<2>(text, 'x');
    if (!sides || !v.range.holds((*sides)[0]) || !v.range.holds((*sides)[1])) return false;
    settings.width = (*sides)[0];
    settings.height = (*sides)[1];
    return true;
  }
  bool operator()(const CropCorners& v) const {
    const auto c = whole_numbers<4>(text, ',');
    if (!c || !std::ranges::all_of(*c, [&](int edge) { return v.range.holds(edge); })) return false;
    settings.crop = PixelWindow{(*c)[0], (*c)[1], (*c)[2], (*c)[3]};
    return true;
  }
  bool operator()(const LayerNames&) const {
    ExtraLayers layers;
    if (!add_layers(text, layers)) return false;
    settings.layers = layers;
    return true;
  }
  bool operator()(const DisplaySpace&) const { return set(find_color_space(text), settings.space); }
  bool operator()(const DisplayTransfer&) const {
    return set(find_transfer(text), settings.transfer);
  }
  bool operator()(const DisplayWhite&) const {
    return set(parse_white_point(text), settings.white_point);
  }

private:
  template <class Value, class Member>
  static bool set(const std::optional<Value>& value, Member& member) {
    if (value) member = *value;
    return value.has_value();
  }
};

struct RightText {
  template <class Settings>
  std::string operator()(const WholeNumber<Settings>& v) const {
    return "a whole number " + words(v.range);
  }
  template <class Settings>
  std::string operator()(const RealNumber<Settings>& v) const {
    return "a number " + words(v.range);
  }
  template <class Settings, class Value>
  std::string operator()(const Choice<Settings, Value>& v) const {
    std::string list;
    for (const Word<Value>& word : v.words)
      list += (list.empty()               ? ""
               : &word == &v.words.back() ? " or "
                                          : ", ") +
              std::string(word.word);
    return list;
  }
  std::string operator()(const SeedNumber&) const {
    return "a seed: a whole number from 0 to 2^64 - 1";
  }
  std::string operator()(const ImageSize& v) const {
    return fmt::format("a size such as 640x480, each side {}", words(v.range));
  }
  std::string operator()(const CropCorners& v) const {
    return fmt::format("a crop x0,y0,x1,y1, each {}", words(v.range));
  }
  std::string operator()(const LayerNames&) const {
    std::string names;
    for (const ExtraLayerName& row : extra_layer_names())
      names += fmt::format("{}, ", row.name);
    return fmt::format("a list of layers with commas between; these are: {}class:*, light:NAME and "
                       "light:*",
                       names);
  }
  std::string operator()(const DisplaySpace&) const {
    return fmt::format("a display; these are: {}", fmt::join(color_space_names(), ", "));
  }
  std::string operator()(const DisplayTransfer&) const {
    return fmt::format("a transfer function; these are: {}, or a gamma from 0.1 to 10",
                       fmt::join(transfer_names(), ", "));
  }
  std::string operator()(const DisplayWhite&) const {
    return "a white point: an illuminant such as D50, x,y such as 0.3457,0.3585, or none";
  }
};

template <class Row, class Settings>
void set(const Row& row, std::string_view text, Settings& settings) {
  if (!std::visit(SetFrom<Settings>{text, settings}, row.value))
    throw UserError(fmt::format("\"{}\" is not {}", text, right_text(row)));
}

template <class Settings, class Given>
Settings with(Settings settings, const Given& given) {
  for (const auto& [row, text] : given)
    set_from_text(*row, text, settings);
  return settings;
}

} // namespace

void set_from_text(const RenderSetting& row, std::string_view text, RenderSettings& settings) {
  set(row, text, settings);
}

void set_from_text(const DisplaySetting& row, std::string_view text, DisplaySettings& settings) {
  set(row, text, settings);
}

std::string right_text(const RenderSetting& row) {
  return std::visit(RightText{}, row.value);
}

std::string right_text(const DisplaySetting& row) {
  return std::visit(RightText{}, row.value);
}

RenderSettings overridden(RenderSettings scene, const SettingsOverride& given) {
  return with(std::move(scene), given);
}

DisplaySettings overridden(DisplaySettings scene, const DisplayOverride& given) {
  return with(std::move(scene), given);
}

const RenderSetting& setting_of_option(std::string_view option) {
  const auto table = render_setting_table();
  const auto row = std::ranges::find(table, option, &RenderSetting::option);
  assert(row != table.end());
  return *row;
}

} // namespace abbe
