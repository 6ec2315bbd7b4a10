// What holds for the whole scene:
//
//   background 0.05 0.05 0.08     ! linear sRGB, or a spectrum by name: background D65 0.1
//   globalAmbient 0.2 0.2 0.2
//   unit cm
//   lights    lights.filter
//   materials all.mtl

#include "io/scene_language/read_scene_state.h"

#include <array>

namespace abbe {
namespace {

void read_background(SceneState& state, Arguments& arguments) {
  state.scene.background = read_emission(state, arguments);
}

void read_global_ambient(SceneState& state, Arguments& arguments) {
  state.scene.global_ambient = read_emission(state, arguments);
}

void read_unit(SceneState& state, Arguments& arguments) {
  state.scene.mm_per_unit = arguments.choice<double>(
      {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"um", 0.001}});
}

void read_light_library(SceneState& state, Arguments& arguments) {
  add_lights(state.libraries, arguments.name_token("the name of a file"));
}

void read_material_library(SceneState& state, Arguments& arguments) {
  add_materials(state.libraries, arguments.name_token("the name of a file"));
}

void read_glass_catalogue(SceneState& state, Arguments& arguments) {
  add_glasses(state.libraries, arguments.name_token("the name of a file"), state.warn);
}

constexpr std::array kSettingKeywords{
    SceneKeyword{"background r g b | SPECTRUM [factor]", read_background},
    SceneKeyword{"globalAmbient r g b | SPECTRUM [factor]", read_global_ambient},
    SceneKeyword{"unit mm|cm|m|in|um", read_unit},
    SceneKeyword{"lights FILE", read_light_library},
    SceneKeyword{"materials FILE", read_material_library},
    SceneKeyword{"glasses FILE", read_glass_catalogue},
};

} // namespace

std::span<const SceneKeyword> setting_keywords() {
  return kSettingKeywords;
}

} // namespace abbe
