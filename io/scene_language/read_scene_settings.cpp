// What holds for the whole scene:
//
//   background 0.05 0.05 0.08     ! linear sRGB, or a spectrum by name: background D65 0.1
//   globalAmbient 0.2 0.2 0.2
//   maxRecursionDepth 8
//   unit cm
//   shadows attenuated
//   lights    lights.filter
//   materials all.mtl

#include "io/scene_language/read_scene_state.h"

#include <array>

namespace abbe {
namespace {

constexpr Range kFraction{"a fraction of the light", 0.0, 1.0};

void read_background(SceneState& state, Arguments& arguments) {
  state.scene.background = read_emission(state, arguments);
}

void read_global_ambient(SceneState& state, Arguments& arguments) {
  state.scene.global_ambient = read_emission(state, arguments);
}

void read_max_recursion_depth(SceneState& state, Arguments& arguments) {
  const auto depth =
      arguments.whole_number({"how often a ray may be reflected or refracted", 0.0, 1e6});
  state.scene.settings.max_depth = static_cast<int>(depth);
}

template <double RenderSettings::* setting>
void read_fraction(SceneState& state, Arguments& arguments) {
  state.scene.settings.*setting = arguments.number(kFraction);
}

void read_unit(SceneState& state, Arguments& arguments) {
  state.scene.mm_per_unit = arguments.choice<double>(
      {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"um", 0.001}});
}

void read_shadows(SceneState& state, Arguments& arguments) {
  state.scene.settings.shadows =
      arguments.choice<ShadowRule>({{"none", ShadowRule::none},
                                    {"opaque", ShadowRule::opaque},
                                    {"attenuated", ShadowRule::attenuated}});
}

void read_light_library(SceneState& state, Arguments& arguments) {
  add_lights(state.libraries, arguments.name_token("the name of a file"));
}

void read_material_library(SceneState& state, Arguments& arguments) {
  add_materials(state.libraries, arguments.name_token("the name of a file"));
}

constexpr std::array kKeywords{
    SceneKeyword{"background r g b | SPECTRUM [factor]", read_background},
    SceneKeyword{"globalAmbient r g b | SPECTRUM [factor]", read_global_ambient},
    SceneKeyword{"maxRecursionDepth n", read_max_recursion_depth},
    SceneKeyword{"minReflectivity x", read_fraction<&RenderSettings::min_reflectivity>},
    SceneKeyword{"minTransparency x", read_fraction<&RenderSettings::min_transparency>},
    SceneKeyword{"minThroughput x", read_fraction<&RenderSettings::min_throughput>},
    SceneKeyword{"unit mm|cm|m|in|um", read_unit},
    SceneKeyword{"shadows none|opaque|attenuated", read_shadows},
    SceneKeyword{"lights FILE", read_light_library},
    SceneKeyword{"materials FILE", read_material_library},
};

} // namespace

std::span<const SceneKeyword> setting_keywords() {
  return kKeywords;
}

} // namespace abbe
