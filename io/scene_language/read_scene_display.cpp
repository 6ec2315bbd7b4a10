// How TIFF and PNG show the scene, and whose eye sees it:
//
//   display display-p3
//   transfer 2.2                  ! or a name: srgb, rec709, linear ...
//   whitePoint A                  ! or a chromaticity: whitePoint 0.4476 0.4074
//   gamut desaturate
//   observer 10deg

#include "io/libraries/read_display.h"
#include "io/scene_language/read_scene_state.h"
#include "io/text/similar_names.h"
#include "spectral/illuminant.h"

#include <fmt/format.h>

#include <array>

namespace abbe {
namespace {

std::string list_of(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

void read_display(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a display");
  const auto space = find_color_space(name.text);
  if (!space)
    throw ReadError(name.where, "unknown display " + shown(name), "no such colour space",
                    did_you_mean(name.text, color_space_names(),
                                 "Give one of " + list_of(color_space_names())));
  state.scene.display.space = *space;
}

void read_transfer(SceneState& state, Arguments& arguments) {
  if (arguments.number_follows()) {
    state.scene.display.transfer =
        power_transfer(arguments.number({"the display's gamma", 0.1, 10.0}));
    return;
  }
  const Token name = arguments.name_token("the name of a transfer function, or a gamma,");
  const auto transfer = find_transfer(name.text);
  if (!transfer)
    throw ReadError(name.where, "unknown transfer function " + shown(name),
                    "it is a name or a gamma from 0.1 to 10",
                    did_you_mean(name.text, transfer_names(),
                                 "Give one of " + list_of(transfer_names()) + ", or a gamma"));
  state.scene.display.transfer = *transfer;
}

void read_white_point(SceneState& state, Arguments& arguments) {
  const SourcePosition where = arguments.reader().peek().where;
  if (arguments.number_follows()) {
    const double x = arguments.number();
    const Chromaticity white{x, arguments.number()};
    if (!can_be_white(white))
      throw ReadError(where, fmt::format("{} {} is no white", white.x, white.y),
                      "no eye can adapt to this chromaticity", "Give x y such as 0.3457 0.3585");
    state.scene.display.white_point = WhitePoint::at(white);
    return;
  }
  const Token name = arguments.name_token("the name of an illuminant, or x y,");
  const auto white = parse_white_point(name.text);
  if (!white)
    throw ReadError(name.where, "unknown white point " + shown(name), "no such illuminant",
                    did_you_mean(name.text, illuminant_names(),
                                 "Give an illuminant such as D50, x y, or none"));
  state.scene.display.white_point = *white;
}

void read_gamut(SceneState& state, Arguments& arguments) {
  state.scene.display.gamut =
      arguments.choice<GamutMapping>({{"clip", GamutMapping::clip},
                                      {"scale", GamutMapping::scale},
                                      {"desaturate", GamutMapping::desaturate}});
}

void read_observer(SceneState& state, Arguments& arguments) {
  state.scene.settings.observer = arguments.choice<Observer>(
      {{"2deg", Observer::cie1931_2deg}, {"10deg", Observer::cie1964_10deg}});
}

constexpr std::array kKeywords{
    SceneKeyword{"display NAME", read_display},
    SceneKeyword{"transfer NAME | GAMMA", read_transfer},
    SceneKeyword{"whitePoint NAME | x y | none", read_white_point},
    SceneKeyword{"gamut clip|scale|desaturate", read_gamut},
    SceneKeyword{"observer 2deg|10deg", read_observer},
};

} // namespace

std::span<const SceneKeyword> display_keywords() {
  return kKeywords;
}

} // namespace abbe
