#include "io/scene_language/read_scene_state.h"

#include "core/scene/quantity_limits.h"
#include "spectral/rgb_spectrum.h"

#include <utility>

namespace abbe {

void warn_at(const SceneState& state, const SourcePosition& where, const std::string& message) {
  state.warn(to_string(where) + ": " + message);
}

LinearRgb read_rgb(Arguments& arguments) {
  constexpr Range kComponent{"a component of a linear sRGB colour", 0.0, kMostLight};
  const double r = arguments.number(kComponent);
  const double g = arguments.number(kComponent);
  return {r, g, arguments.number(kComponent)};
}

Curve read_emission(SceneState& state, Arguments& arguments) {
  if (arguments.number_follows()) return rgb_emission(read_rgb(arguments));
  const Token name = arguments.name_token("a colour or the name of a spectrum");
  Curve spectrum = look_up_light(state.libraries, name, state.warn);
  if (!arguments.number_follows()) return spectrum;
  return spectrum.scaled(arguments.number({"a factor on the spectrum", 0.0, kMostLight}));
}

void place_shape(SceneState& state, const SourcePosition& where, Shape shape,
                 const Transform& to_world, const CurrentMaterial& material) {
  state.builder.add_shape(where, {std::move(shape), to_world, {}, {}, state.priority}, material);
  if (state.object_name.empty()) return;
  state.scene.object_names.resize(state.scene.shapes.size());
  state.scene.object_names.back() = state.object_name;
}

} // namespace abbe
