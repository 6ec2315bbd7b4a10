// Drops that fill the solids that follow, as a glass would; the solid itself is not seen:
//
//   unit m
//   drops 1e-6                          ! extinction per mm
//   push translate 0 100 -500 scale 1000 100 200 cube pop
//
//   drops 1e-6  dropIndex 1.3311        ! of this index instead of water's
//   drops 1e-6  dropSun 0               ! lit by parallel light from a point

#include "core/drops/drop_phase_function.h"
#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "io/scene_language/read_scene_state.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace abbe {
namespace {

void read_drops(SceneState& state, Arguments& arguments) {
  const double extinction =
      arguments.number({.meaning = "an extinction per mm", .highest = 1e9, .open = true});
  Material clear;
  clear.transparency = Curve::constant(1.0);
  clear.fresnel = false;
  Medium air{"drops", ConstantIndex{1.0}, Curve::constant(0.0), Drops{}};
  air.drops->extinction_per_mm = extinction;
  air.drops->index = water_in_air();
  state.material = {clear, air};
}

Drops& current_drops(SceneState& state, const Arguments& arguments) {
  auto& drops = state.material.medium.drops;
  if (!drops)
    throw ReadError(arguments.keyword().where, fmt::format("{} without drops", arguments.name()),
                    "no drops fill the solids that follow", "Give drops before it");
  return *drops;
}

void read_drop_index(SceneState& state, Arguments& arguments) {
  Drops& drops = current_drops(state, arguments);
  if (auto code = read_glass_code(arguments)) {
    drops.index = std::move(code->law);
  } else if (arguments.number_follows()) {
    drops.index = ConstantIndex{arguments.number({"the index of a drop in air", 1.0, 10.0})};
  } else if (is_word(arguments.reader().peek(), "water")) {
    arguments.reader().next();
    drops.index = water_in_air();
  } else {
    drops.index = read_glass(arguments).dispersion;
  }
}

void read_drop_sun(SceneState& state, Arguments& arguments) {
  Drops& drops = current_drops(state, arguments);
  const double radius = arguments.number({"the radius of the sun's disc in degrees", 0.0, 45.0});
  drops.sun_radius = radius * std::numbers::pi / 180.0;
}

constexpr std::array kDropKeywords{
    SceneKeyword{"drops x", read_drops, true},
    SceneKeyword{"dropIndex n | water | GLASS", read_drop_index, true},
    SceneKeyword{"dropSun angle", read_drop_sun, true},
};

} // namespace

std::span<const SceneKeyword> drop_keywords() {
  return kDropKeywords;
}

} // namespace abbe
