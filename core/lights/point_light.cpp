#include "core/lights/point_light.h"

#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

} // namespace

std::optional<dvec3> position(const PointLight& light) {
  return light.position;
}

Illumination illumination(const PointLight& light, const dvec3& point) {
  return illumination_from(light.position, light.falloff, point);
}

std::optional<LightDisc> disc(const PointLight&) {
  return std::nullopt;
}

LightReach reach(const PointLight& light, double value) {
  return reach_from(light.position, light.falloff, value);
}

double power(const PointLight& light, double value, double scene_disc) {
  return light.falloff == Falloff::square ? 4.0 * pi * value : pi * value * scene_disc;
}

double brightest(const PointLight& light, double value, double nearest) {
  return brightest_from(light.falloff, value, nearest);
}

bool endless_flux(const PointLight& light) {
  return light.falloff == Falloff::none;
}

double aim(const PointLight& light, double value, EmissionGoals& goals) {
  return value * solid_angles(goals.targets, light.position);
}

std::optional<LightRay> emit(const PointLight& light, const EmissionGoals& goals,
                             const Sampler& sampler) {
  const DirectionSample towards_goal =
      towards(goals.targets, light.position, sampler.pair(kEmissionDirection));
  return LightRay{{light.position, towards_goal.direction}, 1.0 / towards_goal.pdf};
}

} // namespace abbe
