// Directives about the picture as a whole:
//
//   Integrator "path" "integer maxdepth" 5
//   Film "rgb" "integer xresolution" 512 "integer yresolution" 512
//   Camera "perspective" "float fov" 35

#include "io/pbrt/pbrt_statement.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using glm::dmat4;
using glm::dvec3;

/// Of the camera's place only what mirrors it matters before all shapes are read.
void read_camera(const Statement& s) {
  const std::string type = s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  if (type != "perspective")
    refuse(s.state, s.where, fmt::format("the camera \"{}\"", type), "perspective ones are read");
  s.state.shorter_fov_deg = parameters.number("fov", 90.0);
  if (!(s.state.shorter_fov_deg > 0.0 && s.state.shorter_fov_deg < 180.0))
    throw ReadError(s.where, "fov is no field of view", "it lies between 0 and 180 degrees",
                    "Change it");
  const double lens = parameters.number("lensradius", 0.0);
  const double focus = parameters.number("focaldistance", 1e6);
  if (lens > 0.0) s.state.scene.camera.kind = ThinLens{2.0 * lens, focus};
  parameters.ignore({"shutteropen", "shutterclose"});
  refuse_unused(s.state, parameters);
  s.state.camera = s.state.now.transform;
  s.state.coordinate_systems["camera"] = glm::inverse(s.state.camera);
}

void read_film(const Statement& s) {
  (void)s.string(); // all types of film are one
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  RenderSettings& settings = s.state.scene.settings;
  const auto size = [&](const char* name, double otherwise) {
    const double n = parameters.number(name, otherwise);
    if (!(n >= 1.0 && n <= 65536.0))
      throw ReadError(s.where, fmt::format("{} is no size of a picture", name),
                      "it lies from 1 to 65536", "Change it");
    return static_cast<int>(n);
  };
  settings.width = size("xresolution", 1280);
  settings.height = size("yresolution", 720);
  if (const std::vector<double> p = parameters.numbers("pixelbounds"); p.size() == 4) {
    const auto bound = [&](std::size_t k) {
      return static_cast<int>(std::clamp(p[k], 0.0, 65536.0));
    };
    settings.crop = PixelWindow{bound(0), bound(2), bound(1), bound(3)};
    check_crop(s.where, settings);
    if (settings.crop->x0 >= settings.crop->x1 || settings.crop->y0 >= settings.crop->y1)
      throw ReadError(s.where, "pixelbounds hold no pixel", "they are x0 x1 y0 y1", "Change them");
  }
  // ISO and exposure are the sensor's; the file's name and precision are the command line's.
  parameters.ignore({"filename", "savefp16", "diagonal", "sensor", "iso", "whitebalance",
                     "maxcomponentvalue", "nbuckets", "lambdamin", "lambdamax",
                     "coordinatesystem"});
  refuse_unused(s.state, parameters);
}

void read_integrator(const Statement& s) {
  (void)s.string(); // whatever its type: all find the same light
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  RenderSettings& settings = s.state.scene.settings;
  settings.integrator = Integrator::path;
  settings.max_depth = static_cast<int>(std::clamp(parameters.number("maxdepth", 5.0), 0.0, 1e6));
}
void read_sampler(const Statement& s) {
  (void)s.string();
  PbrtParameters parameters = PbrtParameters::read(s.tokens);
  s.state.scene.settings.samples_per_pixel =
      static_cast<int>(std::clamp(parameters.number("pixelsamples", 16.0), 1.0, 16777216.0));
  s.state.scene.settings.seed =
      static_cast<std::uint64_t>(std::clamp(parameters.number("seed", 0.0), 0.0, 0x1p53));
}
void read_filter(const Statement& s) {
  const std::string type = s.string();
  (void)PbrtParameters::read(s.tokens);
  s.state.scene.settings.filter = type == "box"        ? PixelFilter::box
                                  : type == "triangle" ? PixelFilter::tent
                                                       : PixelFilter::gaussian;
}

/// What a picture does not depend on.
void skip_one_string(const Statement& s) {
  (void)s.string();
  (void)PbrtParameters::read(s.tokens);
}
void skip_option(const Statement& s) {
  (void)PbrtParameters::read(s.tokens);
}
void read_colour_space(const Statement& s) {
  const std::string name = s.string();
  if (name != "srgb")
    refuse(s.state, s.where, fmt::format("the colour space \"{}\"", name), "colours are sRGB");
}

/// A world whose camera sees it mirrored is mirrored, so that ours, which never does, sees it so.
void read_world_begin(const Statement& s) {
  PbrtState& state = s.state;
  const dmat4 to_world = glm::inverse(state.camera);
  if (glm::determinant(glm::dmat3(to_world)) > 0.0)
    state.to_ours = glm::scale(dmat4(1.0), dvec3(-1.0, 1.0, 1.0));
  const dmat4 ours = state.to_ours * to_world;
  Camera& camera = state.scene.camera;
  camera.eye = dvec3(ours[3]);
  camera.look_at = camera.eye + glm::normalize(dvec3(ours[2]));
  camera.up = glm::normalize(dvec3(ours[1]));
  if (auto* lens = std::get_if<ThinLens>(&camera.kind); lens && !lens->focus_distance)
    lens->focus_distance = 1e6;
  const RenderSettings& settings = state.scene.settings;
  const double ratio = std::max(1.0, static_cast<double>(settings.height) / settings.width);
  camera.field_of_view_deg =
      2.0 * std::atan(ratio * std::tan(state.shorter_fov_deg * std::numbers::pi / 360.0)) * 180.0 /
      std::numbers::pi;
  check_view(s.where, camera);
  state.coordinate_systems["world"] = dmat4(1.0);
  state.now.transform = dmat4(1.0);
  state.in_world = true;
}

constexpr std::array kOptions{
    Directive{"Camera", read_camera, Part::options},
    Directive{"Film", read_film, Part::options},
    Directive{"Integrator", read_integrator, Part::options},
    Directive{"Sampler", read_sampler, Part::options},
    Directive{"PixelFilter", read_filter, Part::options},
    Directive{"Accelerator", skip_one_string, Part::options},
    Directive{"Option", skip_option},
    Directive{"ColorSpace", read_colour_space},
    Directive{"WorldBegin", read_world_begin, Part::options},
};

} // namespace

std::span<const Directive> pbrt_options() {
  return kOptions;
}

} // namespace abbe
