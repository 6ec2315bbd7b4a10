// What lies on a surface, and how smooth it is; these are parts of the current material:
//
//   metal Al        roughness 0.3                ! brushed, alike in all directions
//   glass N-BK7     thinFilm 100 1.38            ! an anti-reflection coating
//   speedOfLight 1  transparency 1  reflectivity 1  ambient 0 0 0  diffuse 0 0 0  ! and for
//   thinFilm 400 water-20C                       ! a soap bubble
//   diffuse 0.7 0.1 0.1  coat 1.5                ! plastic
//   thinGlass 4 N-BK7    absorption 0.002        ! a window, of which this is all

#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "io/scene_language/read_scene_state.h"

#include <fmt/format.h>

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

/// A number, or a glass of the catalogue or by its code.
Dispersion read_index(SceneState& state, Arguments& arguments) {
  if (auto code = read_glass_code(arguments)) return std::move(code->law);
  if (arguments.number_follows()) return ConstantIndex{arguments.number(kIndexRange)};
  return read_clear_glass(state, arguments).medium.index;
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

/// A material of its own, as the keyword `glass` gives.
void read_thin_glass(SceneState& state, Arguments& arguments) {
  constexpr Range kThickness{"a thickness in mm", 0.0, 1e6};
  const double mm = arguments.number(kThickness);
  state.material = clear_material({"", read_index(state, arguments), Curve::constant(0.0)});
  state.material.finish.pane = ThinPane{mm, ConstantIndex{1.0}, Curve::constant(0.0)};
}

constexpr std::array kKeywords{
    SceneKeyword{"roughness x", read_roughness, true},
    SceneKeyword{"compensation on|off", read_compensation, true},
    SceneKeyword{"thinFilm thickness n|GLASS", read_thin_film, true},
    SceneKeyword{"coat n|GLASS", read_coat, true},
    SceneKeyword{"thinGlass thickness n|GLASS", read_thin_glass, true},
};

} // namespace

std::span<const SceneKeyword> surface_keywords() {
  return kKeywords;
}

} // namespace abbe
