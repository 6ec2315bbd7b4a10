#include "core/lights/directional_light.h"

#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

} // namespace

std::optional<dvec3> position(const DirectionalLight&) {
  return std::nullopt;
}

Illumination illumination(const DirectionalLight& light, const dvec3&) {
  return illumination_along(light.direction);
}

std::optional<LightDisc> disc(const DirectionalLight&) {
  return std::nullopt;
}

LightReach reach(const DirectionalLight&, double value) {
  return LightReach::distant(pi * value);
}

double power(const DirectionalLight&, double value, double scene_disc) {
  return pi * value * scene_disc;
}

double brightest(const DirectionalLight&, double value, double) {
  return value;
}

bool endless_flux(const DirectionalLight&) {
  return false;
}

double aim(const DirectionalLight&, double value, EmissionGoals& goals) {
  return value * pi * goals.parallel->area();
}

std::optional<LightRay> emit(const DirectionalLight& light, const EmissionGoals& goals,
                             const Sampler& sampler) {
  return parallel_ray(light.direction, *goals.parallel, sampler);
}

} // namespace abbe
