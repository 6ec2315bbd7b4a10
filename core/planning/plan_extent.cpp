#include "core/planning/plan_extent.h"

#include "core/cameras/placed_camera.h"
#include "core/lights/light_kinds.h"
#include "core/lights/scene_extent.h"
#include "core/scene/reach.h"
#include "core/scene/user_error.h"
#include "spectral/observer.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace abbe {
namespace {

/// The padding must not vanish in single precision (1.2e-38).
constexpr double kLeastExtent = 1e-30;

void check_reach(double reach, const std::string& what) {
  if (!(reach <= kFarthestCoordinate)) // nor is what is no number
    throw UserError(fmt::format(
        "{} is too far off: it reaches {:.3g} units from the origin, and rays can be followed to "
        "{:.0e}. Bring it nearer, or measure in larger units",
        what, reach, kFarthestCoordinate));
}

/// What counts of a spectrum when the quantum is chosen: a line at the eye's limits has little Y.
double brightness(const Curve& spectrum, const BandGrid& grid, Observer observer) {
  const auto means = band_means(grid, spectrum);
  return std::max(to_xyz(spectrum, observer).y, *std::max_element(means.begin(), means.end()));
}

/// The same of all lights.
std::vector<double> light_brightness(const Scene& scene, const BandGrid& grid, Observer observer) {
  const double nearest = scene_size(scene) / 16.0;
  std::vector<double> all;
  for (const Light& light : scene.lights)
    all.push_back(brightest(light, brightness(light.spectrum, grid, observer), nearest));
  return all;
}

} // namespace

double film_quantum(const Scene& scene, const BandGrid& grid, Observer observer) {
  const auto brightness = [&](const Curve& spectrum) {
    return abbe::brightness(spectrum, grid, observer);
  };
  double brightest = std::max(brightness(scene.background), brightness(scene.global_ambient));
  for (const double light : light_brightness(scene, grid, observer))
    brightest = std::max(brightest, light);
  if (scene.environment) {
    const Environment& e = *scene.environment;
    const double most =
        e.rgb.empty() ? 0.0 : std::max(0.0f, *std::max_element(e.rgb.begin(), e.rgb.end()));
    brightest = std::max(brightest, brightness(e.light) * e.factor * most);
  }
  for (const Material& material : scene.materials)
    brightest = std::max(brightest, brightness(material.emission));
  return brightest > 0.0 ? std::ldexp(1.0, std::ilogb(brightest) - 36) : 1.0;
}

std::vector<std::size_t> lights_below_quantum(const Scene& scene, const BandGrid& grid,
                                              Observer observer) {
  const double least = 0.5 * film_quantum(scene, grid, observer);
  const std::vector<double> lights = light_brightness(scene, grid, observer);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i] > 0.0 && lights[i] < least) numbers.push_back(i + 1);
  return numbers;
}

void check_extent(const Scene& scene) {
  check_reach(reach_of(scene.camera.eye), "the camera's eye");
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const auto place = position(scene.lights[i]))
      check_reach(reach_of(*place), fmt::format("light number {}", i + 1));
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    check_reach(reach_of(scene.shapes[i]), fmt::format("shape number {}", i + 1));
  const double farthest = farthest_coordinate(scene);
  if (!scene.shapes.empty() && farthest < kLeastExtent)
    throw UserError(fmt::format(
        "the whole scene, camera and all, lies within {:.3g} units of the origin: distances can be "
        "told apart from {:.0e} on. Measure in smaller units",
        farthest, kLeastExtent));
}

double farthest_coordinate(const Scene& scene) {
  double farthest = 0.0;
  const auto include = [&](const dvec3& p) {
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  const dvec3 reach(camera_reach(scene));
  include(scene.camera.eye - reach);
  include(scene.camera.eye + reach);
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) farthest = std::max(farthest, bounds(shape).largest_coordinate());
  for (const Light& light : scene.lights)
    if (const auto place = position(light)) include(*place);
  return farthest;
}

} // namespace abbe
