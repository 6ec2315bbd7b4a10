#include "core/plan_extent.h"

#include "core/plan.h"
#include "spectral/observer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Where a lamp stands; parallel light comes from nowhere.
std::optional<dvec3> position_of(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light.emitter)) return point->position;
  if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) return spot->position;
  return std::nullopt;
}

/// A sun can be looked at, but a tiny one must not make the steps too coarse for what it lights:
/// they stay below 2^-16 of that.
constexpr double kMostOfSun = 0x1p20;

} // namespace

double scene_size(const Scene& scene) {
  Bounds box;
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) box = box.joined(bounds(shape));
  for (const Light& light : scene.lights)
    if (const auto position = position_of(light)) box = box.joined({*position, *position});
  return box.empty() ? 0.0 : glm::length(box.upper - box.lower);
}

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
  include(scene.camera.eye);
  for (const PlacedShape& shape : scene.shapes)
    if (is_bounded(shape.shape)) farthest = std::max(farthest, bounds(shape).largest_coordinate());
  for (const Light& light : scene.lights)
    if (const auto position = position_of(light)) include(*position);
  return farthest;
}

} // namespace abbe
