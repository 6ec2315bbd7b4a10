// How light that goes by mirrors and glass is found, with the integrator path:
//
//   caustics on
//   lightPaths 0.5         ! per camera sample
//   photonRadius 0.2       ! of the first pass, in scene units

#include "io/scene_language/read_scene_state.h"

#include <array>
#include <limits>

namespace abbe {
namespace {

void read_caustics(SceneState& state, Arguments& arguments) {
  state.scene.settings.caustics = arguments.choice<Caustics>(
      {{"on", Caustics::on}, {"off", Caustics::off}, {"automatic", Caustics::automatic}});
}

void read_light_paths(SceneState& state, Arguments& arguments) {
  state.scene.settings.light_paths =
      arguments.number({"a number of light paths per camera sample", 0.0, 1e6, true});
}

void read_photon_radius(SceneState& state, Arguments& arguments) {
  state.scene.settings.photon_radius =
      arguments.number({"a length", 0.0, std::numeric_limits<double>::infinity(), true});
}

constexpr std::array kKeywords{
    SceneKeyword{"caustics on|off|automatic", read_caustics},
    SceneKeyword{"lightPaths x", read_light_paths},
    SceneKeyword{"photonRadius x", read_photon_radius},
};

} // namespace

std::span<const SceneKeyword> light_path_keywords() {
  return kKeywords;
}

} // namespace abbe
