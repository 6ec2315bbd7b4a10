// What lies on a surface, and how smooth it is; these are parts of the current material:
//
//   metal Al        roughness 0.3                ! brushed, alike in all directions
//   glass N-BK7     thinFilm 100 1.38            ! an anti-reflection coating
//   speedOfLight 1  transparency 1  reflectivity 1  ambient 0 0 0  diffuse 0 0 0  ! and for
//   thinFilm 400 water-20C                       ! a soap bubble
//   diffuse 0.7 0.1 0.1  coat 1.5                ! plastic

#include "io/scene_language/read_scene_state.h"

#include <array>

namespace abbe {
namespace {

void read_roughness(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.roughness = arguments.number({"a roughness", 0.0, 1.0});
}

void read_compensation(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.compensation = arguments.on_off();
}

void read_thin_film(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  const double nm = arguments.number({"a thickness in nm, 0 for none", 0.0, 1e6});
  Dispersion index = read_index(state, arguments);
  state.material.finish.film.reset();
  if (nm > 0.0) state.material.finish.film = ThinFilm{nm, std::move(index)};
}

void read_coat(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.coat = read_index(state, arguments);
}

constexpr std::array kSurfaceKeywords{
    SceneKeyword{"roughness x", read_roughness, true},
    SceneKeyword{"compensation on|off", read_compensation, true},
    SceneKeyword{"thinFilm thickness n|GLASS", read_thin_film, true},
    SceneKeyword{"coat n|GLASS", read_coat, true},
};

} // namespace

std::span<const SceneKeyword> surface_keywords() {
  return kSurfaceKeywords;
}

} // namespace abbe
