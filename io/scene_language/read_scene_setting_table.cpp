// The settings that are rows of the table of settings, each by its keyword:
//
//   imageSize 640 480
//   crop 100 100 200 150      ! x0 y0 x1 y1, from the top left; x1 and y1 are outside
//   samples 64
//   noise 0.05                ! then 64 samples are the most
//   filter gaussian
//   display display-p3
//   transfer 2.2              ! or a name: srgb, rec709, linear ...
//   whitePoint A              ! or a chromaticity: whitePoint 0.4476 0.4074

#include "core/scene/setting_table.h"
#include "io/libraries/read_display.h"
#include "io/scene_language/read_scene_state.h"
#include "io/text/similar_names.h"
#include "spectral/data_table.h"
#include "spectral/illuminant.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace abbe {
namespace {

template <class Settings, class Value>
void read_choice(const Choice<Settings, Value>& choice, Settings& settings, Arguments& arguments) {
  std::vector<std::string> names;
  for (const Word<Value>& word : choice.words)
    names.emplace_back(word.word);
  settings.*choice.member = choice.words[arguments.chosen(names)].value;
}

/// Reads the arguments of one kind of value into the scene's settings.
struct ReadRenderValue {
  SceneState& state;
  Arguments& arguments;
  RenderSettings& settings;

  void operator()(const WholeNumber<RenderSettings>& v) const {
    settings.*v.member = static_cast<int>(arguments.whole_number(v.range));
  }
  void operator()(const RealNumber<RenderSettings>& v) const {
    settings.*v.member = arguments.number(v.range);
  }
  void operator()(const SeedNumber& v) const { settings.*v.member = arguments.seed(); }
  template <class Value>
  void operator()(const RenderChoice<Value>& choice) const {
    read_choice(choice, settings, arguments);
  }
  void operator()(const ImageSize& v) const {
    settings.width = static_cast<int>(arguments.whole_number(v.range));
    settings.height = static_cast<int>(arguments.whole_number(v.range));
  }
  void operator()(const CropCorners& v) const {
    std::array<int, 4> edges{};
    for (int& edge : edges)
      edge = static_cast<int>(arguments.whole_number(v.range));
    const PixelWindow window{edges[0], edges[1], edges[2], edges[3]};
    if (window.width() <= 0 || window.height() <= 0)
      throw ReadError(arguments.keyword().where, "the crop holds no pixel",
                      "its right and lower edges must be beyond the left and upper ones",
                      "Give x0 y0 x1 y1 with x0 < x1 and y0 < y1");
    settings.crop = window;
    state.crop_at = arguments.keyword().where;
  }
  void operator()(const LayerNames&) const {
    const Token names = arguments.name_token("a list of layers");
    ExtraLayers layers;
    if (!add_layers(names.text, layers))
      throw ReadError(names.where, "unknown layers " + shown(names), "no such layer",
                      "docs/layers.md lists them");
    settings.layers = layers;
  }
};

std::string list_of(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The same for the display's settings.
struct ReadDisplayValue {
  Arguments& arguments;
  DisplaySettings& settings;

  void operator()(const RealNumber<DisplaySettings>& v) const {
    settings.*v.member = arguments.number(v.range);
  }
  template <class Value>
  void operator()(const Choice<DisplaySettings, Value>& choice) const {
    read_choice(choice, settings, arguments);
  }
  void operator()(const DisplaySpace&) const {
    const Token name = arguments.name_token("the name of a display");
    const auto space = find_color_space(name.text);
    if (!space)
      throw ReadError(name.where, "unknown display " + shown(name), "no such colour space",
                      did_you_mean(name.text, color_space_names(),
                                   "Give one of " + list_of(color_space_names())));
    settings.space = *space;
  }
  void operator()(const DisplayTransfer&) const {
    if (arguments.number_follows()) {
      settings.transfer = power_transfer(arguments.number({"the display's gamma", 0.1, 10.0}));
      return;
    }
    const Token name = arguments.name_token("the name of a transfer function, or a gamma,");
    const auto transfer = find_transfer(name.text);
    if (!transfer)
      throw ReadError(name.where, "unknown transfer function " + shown(name),
                      "it is a name or a gamma from 0.1 to 10",
                      did_you_mean(name.text, transfer_names(),
                                   "Give one of " + list_of(transfer_names()) + ", or a gamma"));
    settings.transfer = *transfer;
  }
  void operator()(const DisplayWhite&) const {
    const SourcePosition where = arguments.reader().peek().where;
    if (arguments.number_follows()) {
      const double x = arguments.number();
      const Chromaticity white{x, arguments.number()};
      if (!can_be_white(white))
        throw ReadError(where, fmt::format("{} {} is no white", white.x, white.y),
                        "no eye can adapt to this chromaticity", "Give x y such as 0.3457 0.3585");
      settings.white_point = WhitePoint::at(white);
      return;
    }
    const Token name = arguments.name_token("the name of an illuminant, or x y,");
    const auto white = parse_white_point(name.text);
    if (!white)
      throw ReadError(name.where, "unknown white point " + shown(name), "no such illuminant",
                      did_you_mean(name.text, illuminant_names(),
                                   "Give an illuminant such as D50, x y, or none"));
    settings.white_point = *white;
  }
};

template <class Row>
const Row& row_of(std::span<const Row> table, std::string_view keyword) {
  const auto row = std::ranges::find(table, keyword, &Row::keyword);
  assert(row != table.end());
  return *row;
}

void read_render_setting(SceneState& state, Arguments& arguments) {
  std::visit(ReadRenderValue{state, arguments, state.scene.settings},
             row_of(render_setting_table(), arguments.name()).value);
}

void read_display_setting(SceneState& state, Arguments& arguments) {
  std::visit(ReadDisplayValue{arguments, state.scene.display},
             row_of(display_setting_table(), arguments.name()).value);
}

/// The usage of each row that has a keyword.
template <class Row>
std::vector<std::string> usages_of(std::span<const Row> table) {
  std::vector<std::string> usages;
  for (const Row& row : table)
    if (!row.keyword.empty())
      usages.push_back(fmt::format("{} {}", row.keyword,
                                   row.arguments.empty() ? choice_words(row) : row.arguments));
  return usages;
}

} // namespace

std::span<const SceneKeyword> table_keywords() {
  static const std::vector<std::string> render = usages_of(render_setting_table());
  static const std::vector<std::string> display = usages_of(display_setting_table());
  static const std::vector<SceneKeyword> rows = [] {
    std::vector<SceneKeyword> list;
    for (const std::string& usage : render)
      list.push_back({usage, read_render_setting});
    for (const std::string& usage : display)
      list.push_back({usage, read_display_setting});
    return list;
  }();
  return rows;
}

} // namespace abbe
