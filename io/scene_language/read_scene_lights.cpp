// Lights stand where the current transform puts them:
//
//   light 0 5 0  1 0.9 0.8                     ! Hill: a point, and a linear sRGB colour
//   light 2a  0 5 0  1                         ! thesis: name, position, 1 = at that position
//   light D65  1 2 0  0                        ! 0 = from that direction, parallel
//   falloff square
//   intensity 40                       ! or lumen 800, candela 60, watt 5, lux 10000
//   softEdge 0.5
//   sunRadius 0.2665
//   sun 1 3 2                          ! the direction it comes from; or: sun 1 3 2 D65
//   environment sky.exr                ! a picture of all directions; or: environment sky.exr D65
//   0.5 spotlight 2a  0 0 -10  1  0 0 1  2         ! ..., direction, half-angle in degrees

#include "geometry/rays/largest_component.h"
#include "io/building/check_reach.h"
#include "io/images/read_environment.h"
#include "io/scene_language/read_scene_state.h"
#include "spectral/illuminant.h"
#include "spectral/radiator.h"
#include "spectral/rgb_spectrum.h"

#include "core/scene/quantity_limits.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// The sun's effective temperature, of which its spectrum in the visible is not far [Cox00].
constexpr double kSunKelvin = 5778.0;

double radians(double angle_deg) {
  return angle_deg * std::numbers::pi / 180.0;
}

/// A position of the file in the world.
dvec3 world_position(const SceneState& state, Arguments& arguments, const dvec3& place) {
  const dvec3 position = state.transform.point(place);
  check_reach(arguments.keyword().where, "the light", reach_of(position));
  return position;
}

void add_light(SceneState& state, const Arguments& arguments, std::string name,
               const Curve& spectrum, const LightKind& kind) {
  Light light{std::move(name), spectrum, kind, state.light.group};
  set_strength(arguments.keyword().where, light, state.light.strength, state.scene.mm_per_unit);
  note_light(state.given, light, arguments.keyword().where);
  state.builder.add_light(std::move(light), state.light.given);
}

/// A direction of the file, not 0 0 0, in the world and of unit length.
dvec3 world_direction(const SceneState& state, const dvec3& direction) {
  return glm::normalize(state.transform.vector(direction / largest_component(direction)));
}

bool read_is_local(Arguments& arguments) {
  return arguments.choice<bool>({{"1", true}, {"0", false}});
}

void read_light(SceneState& state, Arguments& arguments) {
  if (arguments.number_follows()) {
    const dvec3 position = world_position(state, arguments, arguments.vector());
    add_light(state, arguments, "", rgb_emission(read_rgb(arguments)),
              PointLight{position, state.light.falloff});
    return;
  }
  const Token name = arguments.name_token("the name of a light, or a position,");
  const Curve spectrum = look_up_light(state.libraries, name, state.warn);
  const SourcePosition where = arguments.reader().peek().where;
  const dvec3 place = arguments.vector();
  if (read_is_local(arguments)) {
    add_light(state, arguments, name.text, spectrum,
              PointLight{world_position(state, arguments, place), state.light.falloff});
    return;
  }
  if (largest_component(place) == 0.0)
    throw ReadError(where, "light from the direction 0 0 0",
                    "its locality is 0, so x y z is the direction it comes from",
                    "Give a direction such as 0 1 0, or the locality 1");
  add_light(state, arguments, name.text, spectrum,
            DirectionalLight{-world_direction(state, place)});
}

void read_spotlight(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a light");
  const Curve spectrum = look_up_light(state.libraries, name, state.warn);
  SpotLight spot;
  spot.position = world_position(state, arguments, arguments.vector());
  const SourcePosition locality_at = arguments.reader().peek().where;
  if (!read_is_local(arguments))
    throw ReadError(locality_at, "a spotlight has the locality 0", "a cone begins at a position",
                    "Give the locality 1");
  const SourcePosition axis_at = arguments.reader().peek().where;
  const dvec3 axis = arguments.vector();
  if (largest_component(axis) == 0.0)
    throw ReadError(axis_at, "the direction of a spotlight is 0 0 0", arguments.takes(),
                    "Give a direction such as 0 -1 0");
  spot.axis = world_direction(state, axis);
  const SourcePosition angle_at = arguments.reader().peek().where;
  const double angle_deg =
      arguments.number({"half the angle of the cone, in degrees", 0.0, 90.0, true});
  if (state.light.soft_edge_deg > angle_deg)
    throw ReadError(angle_at, "the spotlight is narrower than its soft edge",
                    fmt::format("softEdge is {} degrees, the half-angle {}",
                                state.light.soft_edge_deg, angle_deg),
                    "Give a smaller softEdge before it");
  spot.half_angle = radians(angle_deg);
  spot.full_angle = radians(angle_deg - state.light.soft_edge_deg);
  spot.falloff = state.light.falloff;
  add_light(state, arguments, name.text, spectrum, spot);
}

void read_sun(SceneState& state, Arguments& arguments) {
  const SourcePosition where = arguments.reader().peek().where;
  const dvec3 place = arguments.vector();
  if (largest_component(place) == 0.0)
    throw ReadError(where, "a sun in the direction 0 0 0", "x y z is the direction it comes from",
                    "Give a direction such as 0 1 0");
  Curve spectrum = blackbody(kSunKelvin);
  if (name_follows(arguments))
    spectrum =
        look_up_light(state.libraries, arguments.name_token("the name of a spectrum"), state.warn);
  add_light(state, arguments, "sun", spectrum,
            SunLight{-world_direction(state, place), state.light.sun_radius});
}

void read_sun_radius(SceneState& state, Arguments& arguments) {
  state.light.sun_radius =
      radians(arguments.number({"half the angle of a sun's disc, in degrees", 0.01, 90.0}));
}

/// The current transform without its stretch, which must be the same in all directions.
glm::dmat3 rotation_of(const SceneState& state, const SourcePosition& where) {
  glm::dmat3 axes(1.0);
  const double length = glm::length(state.transform.vector(axes[0]));
  for (int i = 0; i < 3; ++i)
    axes[i] = state.transform.vector(axes[i]) / length;
  const glm::dmat3 product = glm::transpose(axes) * axes;
  constexpr double kNoticeable = 1e-9; // far above what a chain of rotations rounds
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) > kNoticeable)
        throw ReadError(where, "the current transform stretches the environment",
                        "angles would no longer be those of the picture",
                        "Give it before the scale, or scale all axes alike");
  return axes;
}

void read_environment_picture(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a file");
  add_input(state.files, name);
  Environment environment = read_environment(name, state.warn);
  environment.to_world = rotation_of(state, arguments.keyword().where);
  environment.has_colors = !name_follows(arguments);
  environment.light =
      environment.has_colors
          ? *find_illuminant("D65")
          : look_up_light(state.libraries, arguments.name_token("the name of a spectrum"),
                          state.warn);
  if (arguments.number_follows())
    environment.factor = arguments.number({"a factor on the picture", 0.0, kMostLight});
  const auto most = std::ranges::max_element(environment.rgb);
  if (most != environment.rgb.end() && *most * environment.factor > kMostLight)
    throw ReadError(
        name.where, fmt::format("{} is too bright", shown(name)),
        fmt::format("a component of it times the factor is {:g}", *most * environment.factor),
        fmt::format("Give a factor that keeps it below {:g}", kMostLight));
  state.scene.environment = std::move(environment);
}

void read_falloff(SceneState& state, Arguments& arguments) {
  state.light.falloff =
      arguments.choice<Falloff>({{"none", Falloff::none}, {"square", Falloff::square}});
}

void read_intensity(SceneState& state, Arguments& arguments) {
  state.light.strength = {arguments.number({"a factor on the lights that follow", 0.0, kMostLight}),
                          LightUnit::factor};
}

template <LightUnit unit>
void read_strength(SceneState& state, Arguments& arguments) {
  state.light.strength = {
      arguments.number({"the strength of the lights that follow", 0.0, kMostLight}), unit};
}

void read_soft_edge(SceneState& state, Arguments& arguments) {
  state.light.soft_edge_deg =
      arguments.number({"the width of a spotlight's edge, in degrees", 0.0, 90.0});
}

constexpr std::array kLightKeywords{
    SceneKeyword{"light x y z r g b | NAME x y z LOCALITY", read_light},
    SceneKeyword{"spotlight NAME x y z LOCALITY dx dy dz angle", read_spotlight},
    SceneKeyword{"sun x y z [SPECTRUM]", read_sun},
    SceneKeyword{"sunRadius angle", read_sun_radius},
    SceneKeyword{"environment FILE [SPECTRUM] [factor]", read_environment_picture},
    SceneKeyword{"falloff none|square", read_falloff},
    SceneKeyword{"intensity x", read_intensity},
    SceneKeyword{"candela x", read_strength<LightUnit::candela>},
    SceneKeyword{"lumen x", read_strength<LightUnit::lumen>},
    SceneKeyword{"watt x", read_strength<LightUnit::watt>},
    SceneKeyword{"lux x", read_strength<LightUnit::lux>},
    SceneKeyword{"softEdge angle", read_soft_edge},
};

} // namespace

std::span<const SceneKeyword> light_keywords() {
  return kLightKeywords;
}

} // namespace abbe
