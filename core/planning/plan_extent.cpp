#include "core/planning/plan_extent.h"

#include "core/cameras/lens_system.h"
#include "core/scene/scene_extent.h"
#include "spectral/observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// A sun can be looked at, but a tiny one must not make the steps too coarse for what it lights:
/// they stay below 2^-16 of that.
constexpr double kMostOfSun = 0x1p20;

/// How far from the eye camera rays may begin: on a thin lens, or on the first surface of a real
/// one, whose rim lies no farther behind the vertex than from the axis.
double camera_reach(const Scene& scene) {
  const Camera& camera = scene.camera;
  if (!camera.lens) return 0.5 * camera.aperture;
  const double semi_diameter = LensSystem(*camera.lens).surfaces().front().semi_diameter;
  return std::numbers::sqrt2 * semi_diameter / scene.mm_per_unit;
}

} // namespace

double film_quantum(const Scene& scene, const BandGrid& grid, Observer observer) {
  const auto brightness = [&](const Curve& spectrum) { // a line at the eye's limits has little Y
    const auto means = band_means(grid, spectrum);
    return std::max(to_xyz(spectrum, observer).y, *std::max_element(means.begin(), means.end()));
  };
  double brightest = std::max(brightness(scene.background), brightness(scene.global_ambient));
  const double way = scene_size(scene) / 16.0;
  for (const Light& light : scene.lights) {
    const double value = brightness(light.spectrum);
    if (const auto* sun = std::get_if<SunLight>(&light.emitter))
      brightest = std::max(brightest, value * std::min(sun->radiance_per_value(), kMostOfSun));
    else if (light.falloff == Falloff::none)
      brightest = std::max(brightest, value);
    else if (way > 0.0)
      brightest = std::max(brightest, value / (way * way));
  }
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
    if (const auto position = position_of(light)) include(*position);
  return farthest;
}

} // namespace abbe
