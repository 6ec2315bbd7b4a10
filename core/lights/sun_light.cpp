#include "core/lights/sun_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

/// A sun can be looked at, but a tiny one must not make the film's quantum too coarse for what it
/// lights: it stays below 2^-16 of that.
constexpr double kMostOfSun = 0x1p20;

/// The radiance of the disc, per unit of the light's value.
double radiance(const SunLight& light) {
  const double sine = std::sin(light.angular_radius);
  return 1.0 / (sine * sine);
}

/// The cone about a direction that is as wide as the disc.
Cone cone_about(const SunLight& light, const dvec3& direction) {
  const double sine = std::sin(light.angular_radius);
  return Cone::of_sine(direction, sine * sine);
}

} // namespace

std::optional<dvec3> position(const SunLight&) {
  return std::nullopt;
}

Illumination illumination(const SunLight& light, const dvec3&) {
  return illumination_along(light.direction);
}

std::optional<LightDisc> disc(const SunLight& light) {
  return LightDisc{cone_about(light, -light.direction), radiance(light)};
}

LightReach reach(const SunLight&, double value) {
  return LightReach::distant(pi * value);
}

double power(const SunLight&, double value, double scene_disc) {
  return pi * value * scene_disc;
}

double brightest(const SunLight& light, double value, double) {
  return value * std::min(radiance(light), kMostOfSun);
}

bool endless_flux(const SunLight&) {
  return false;
}

double aim(const SunLight&, double value, EmissionGoals& goals) {
  return value * pi * goals.parallel->area();
}

/// Chooses a direction of the disc, and parallel light along it.
std::optional<LightRay> emit(const SunLight& light, const EmissionGoals& goals,
                             const Sampler& sampler) {
  const Cone directions = cone_about(light, light.direction);
  LightRay ray =
      parallel_ray(directions.sample(sampler.pair(kEmissionDirection)), *goals.parallel, sampler);
  // The irradiance is the disc's radiance times its solid angle, where parallel_ray took pi.
  ray.flux *= radiance(light) / directions.pdf() / pi;
  return ray;
}

} // namespace abbe
