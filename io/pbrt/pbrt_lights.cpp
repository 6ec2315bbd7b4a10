// Lights:
//
//   LightSource "spot" "spectrum I" "stdillum-D65" "float scale" 2000 "point3 from" [ 0 5 0 ]
//   AreaLightSource "diffuse" "rgb L" [ 1 1 1 ] "float scale" 10

#include "core/scene/quantity_limits.h"
#include "io/building/check_reach.h"
#include "io/pbrt/pbrt_state.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>

namespace abbe {
namespace {

using glm::dvec3;

constexpr double kRadians = std::numbers::pi / 180.0;

glm::dmat4 world_of(const PbrtState& state) {
  return state.to_ours * state.now.transform;
}

dvec3 point(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters,
            std::string_view name, const dvec3& otherwise) {
  const auto found = parameters.points(name);
  const dvec3 p = found && found->size() == 1 ? (*found)[0] : otherwise;
  const dvec3 placed(world_of(state) * glm::dvec4(p, 1.0));
  check_reach(where, "the light", reach_of(placed));
  return placed;
}

/// From one point to another, unit.
dvec3 direction(const SourcePosition& where, const dvec3& from, const dvec3& to) {
  const double length = glm::length(to - from);
  if (!(length > 0.0))
    throw ReadError(where, "a light has no direction", "from and to are the same point",
                    "Move one of them");
  return (to - from) / length;
}

double read_scale(const SourcePosition& where, PbrtParameters& parameters) {
  const double scale = parameters.number("scale", 1.0);
  if (scale >= 0.0 && scale <= kMostLight) return scale;
  throw ReadError(where, fmt::format("a light has the scale {:g}", scale),
                  fmt::format("it lies from 0 to {:g}", kMostLight), "Change it");
}

/// Throws for parameters that would give a light another unit.
void refuse_units(PbrtState& state, PbrtParameters& parameters,
                  std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names)
    if (const PbrtParameter* found = parameters.find(name))
      refuse(state, found->where, fmt::format("{} of a light", name),
             "its value and scale say how bright it is");
}

} // namespace

void read_pbrt_light(PbrtState& state, const SourcePosition& where, const std::string& type,
                     PbrtParameters& parameters) {
  const double scale = read_scale(where, parameters);
  if (type == "infinite") {
    refuse_units(state, parameters, {"filename", "portal", "illuminance"});
    if (!state.scene.background.zero())
      refuse(state, where, "a second infinite light", "a scene has one background");
    state.scene.background = read_light_spectrum(state, parameters, "L").scaled(scale);
  } else if (type == "point") {
    refuse_units(state, parameters, {"power"});
    const Curve spectrum = read_light_spectrum(state, parameters, "I").scaled(scale);
    state.builder.add_light(
        {"point", spectrum,
         PointLight{point(state, where, parameters, "from", dvec3(0.0)), Falloff::square}});
  } else if (type == "spot") {
    refuse_units(state, parameters, {"power"});
    const Curve spectrum = read_light_spectrum(state, parameters, "I").scaled(scale);
    SpotLight spot;
    spot.position = point(state, where, parameters, "from", dvec3(0.0));
    spot.axis = direction(where, spot.position,
                          point(state, where, parameters, "to", dvec3(0.0, 0.0, 1.0)));
    const double angle = parameters.number("coneangle", 30.0);
    const double soft = parameters.number("conedeltaangle", 5.0);
    if (!(angle > 0.0 && angle < 90.0 && soft >= 0.0 && soft <= angle))
      throw ReadError(where, "the cone of a spot is too wide or too narrow",
                      "coneangle lies between 0 and 90, conedeltaangle from 0 to coneangle",
                      "Change one of them");
    spot.half_angle = angle * kRadians;
    spot.full_angle = (angle - soft) * kRadians;
    spot.falloff = Falloff::square;
    state.builder.add_light({"spot", spectrum, spot});
  } else if (type == "distant") {
    const dvec3 from = point(state, where, parameters, "from", dvec3(0.0));
    const dvec3 to = point(state, where, parameters, "to", dvec3(0.0, 0.0, 1.0));
    const double irradiance = std::clamp(parameters.number("illuminance", 1.0), 0.0, kMostLight);
    const Curve spectrum = read_light_spectrum(state, parameters, "L");
    state.builder.add_light({"distant", spectrum.scaled(scale * irradiance / std::numbers::pi),
                             DirectionalLight{direction(where, from, to)}});
  } else {
    refuse(state, where, fmt::format("the light \"{}\"", type),
           "point, spot, distant, infinite and area lights are read");
    return;
  }
  refuse_unused(state, parameters);
}

void read_pbrt_area_light(PbrtState& state, const SourcePosition& where, const std::string& type,
                          PbrtParameters& parameters) {
  if (type != "diffuse")
    return refuse(state, where, fmt::format("the area light \"{}\"", type),
                  "diffuse ones are read");
  refuse_units(state, parameters, {"power", "filename"});
  const double scale = read_scale(where, parameters);
  state.now.two_sided = parameters.flag("twosided", false);
  state.now.emission =
      std::make_shared<const Curve>(read_light_spectrum(state, parameters, "L").scaled(scale));
  refuse_unused(state, parameters);
}

} // namespace abbe
