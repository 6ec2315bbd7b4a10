// Cameras, and the lights of KHR_lights_punctual. Both look along -z of their node, with +y up.

#include "io/building/check_reach.h"
#include "io/gltf/gltf_state.h"
#include "spectral/rgb_spectrum.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using glm::dvec3;
using glm::dvec4;

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Where a vector of the node points, unit.
dvec3 direction(const GltfValue& where, const glm::dmat4& to_world, const dvec3& v) {
  const dvec3 moved(to_world * dvec4(v, 0.0));
  const double length = glm::length(moved);
  if (!(length > 0.0 && std::isfinite(1.0 / length)))
    throw ReadError(where.where(), "this has no direction", "its node has no extent",
                    "Check the node's scale");
  return moved / length;
}

void set_width(GltfState& state, double ratio) {
  RenderSettings& settings = state.scene.settings;
  settings.width = static_cast<int>(std::clamp(std::round(settings.height * ratio), 1.0, 65536.0));
}

} // namespace

void read_gltf_camera(GltfState& state, const GltfValue& camera, const glm::dmat4& to_world) {
  if (state.has_camera)
    return refuse(state, camera, "a second camera", "the first of the scene sees it");
  refuse_extensions(state, camera, {});
  if (camera.string("type", "") != "perspective")
    return refuse(state, camera, fmt::format("a camera \"{}\"", camera.string("type", "")),
                  "perspective ones are read");
  const auto perspective = camera.find("perspective");
  if (!perspective)
    throw ReadError(camera.where(), "the camera has no field of view",
                    "it is the yfov of its perspective", "Add it");
  state.has_camera = true;
  Camera& ours = state.scene.camera;
  ours.field_of_view_deg = perspective->number("yfov", 1e-6, 3.1415).value_or(0.8) * kDegrees;
  if (const auto ratio = perspective->number("aspectRatio", 1e-4, 1e4)) set_width(state, *ratio);
  ours.eye = dvec3(to_world[3]);
  check_reach(camera.where(), "the camera", reach_of(ours.eye));
  ours.look_at = ours.eye + direction(camera, to_world, {0.0, 0.0, -1.0});
  ours.up = direction(camera, to_world, {0.0, 1.0, 0.0});
  check_view(camera.where(), ours);
}

void read_gltf_light(GltfState& state, const GltfValue& light, const std::string& name,
                     const glm::dmat4& to_world) {
  refuse_extensions(state, light, {});
  const auto c = light.numbers<3>("color", {1.0, 1.0, 1.0});
  const double intensity = light.number("intensity", 0.0, 1e12).value_or(1.0);
  const Curve spectrum =
      rgb_emission({std::min(c[0], 1.0), std::min(c[1], 1.0), std::min(c[2], 1.0)})
          .scaled(intensity);
  const std::string type = light.string("type", "");
  const dvec3 position(to_world[3]);
  check_reach(light.where(), "the light", reach_of(position));
  if (light.find("range"))
    refuse(state, *light.find("range"), "the range of a light", "light has no end");
  const std::string shown = light.string("name", name.empty() ? type : name);
  if (type == "point") {
    state.builder.add_light({shown, spectrum, PointLight{position, Falloff::square}});
  } else if (type == "directional") {
    // Its irradiance in lux, which is pi times the value of ours.
    state.builder.add_light({shown, spectrum.scaled(1.0 / std::numbers::pi),
                             DirectionalLight{direction(light, to_world, {0.0, 0.0, -1.0})}});
  } else if (type == "spot") {
    SpotLight spot;
    spot.position = position;
    spot.axis = direction(light, to_world, {0.0, 0.0, -1.0});
    spot.half_angle = std::numbers::pi / 4.0;
    spot.full_angle = 0.0;
    if (const auto cone = light.find("spot")) {
      constexpr double kMost = 1.5707; // a right angle is no cone
      spot.half_angle =
          std::min(cone->number("outerConeAngle", 1e-6, 1.5708).value_or(spot.half_angle), kMost);
      spot.full_angle =
          std::min(cone->number("innerConeAngle", 0.0, 1.5708).value_or(0.0), spot.half_angle);
    }
    spot.falloff = Falloff::square;
    state.builder.add_light({shown, spectrum, spot});
  } else {
    refuse(state, light, fmt::format("a light \"{}\"", type),
           "point, spot and directional ones are read");
  }
}

} // namespace abbe
