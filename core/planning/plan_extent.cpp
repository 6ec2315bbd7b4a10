#include "core/planning/plan_extent.h"

#include "core/cameras/placed_camera.h"
#include "core/lights/light_kinds.h"
#include "core/lights/scene_extent.h"
#include "spectral/observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {
double film_quantum(const Scene& scene, const BandGrid& grid, Observer observer) {
  const auto brightness = [&](const Curve& spectrum) { // a line at the eye's limits has little Y
    const auto means = band_means(grid, spectrum);
    return std::max(to_xyz(spectrum, observer).y, *std::max_element(means.begin(), means.end()));
  };
  double brightest = std::max(brightness(scene.background), brightness(scene.global_ambient));
  const double nearest = scene_size(scene) / 16.0;
  for (const Light& light : scene.lights)
    brightest = std::max(brightest, abbe::brightest(light, brightness(light.spectrum), nearest));
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
