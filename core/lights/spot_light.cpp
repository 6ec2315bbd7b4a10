#include "core/lights/spot_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

using std::numbers::pi;

Cone cone_of(const SpotLight& light) {
  const double s = std::sin(0.5 * light.half_angle);
  return {light.axis, 2.0 * s * s};
}

/// True when the cones have a direction in common.
bool overlap(const Cone& a, const Cone& b) {
  const auto half_angle = [](const Cone& c) {
    return std::acos(std::clamp(1.0 - c.one_minus_cos, -1.0, 1.0));
  };
  const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
  return between <= half_angle(a) + half_angle(b);
}

/// The part, 0 to 1, of the full brightness that goes along a unit direction.
double brightness_towards(const SpotLight& light, const dvec3& direction) {
  const double angle = std::acos(std::clamp(glm::dot(direction, light.axis), -1.0, 1.0));
  if (angle >= light.half_angle) return 0.0;
  if (angle <= light.full_angle) return 1.0;
  const double x = (light.half_angle - angle) / (light.half_angle - light.full_angle);
  return x * x * (3.0 - 2.0 * x); // the smooth step
}

/// The solid angle in which the light shines, with half of the soft edge.
double solid_angle(const SpotLight& light) {
  return 2.0 * pi * (1.0 - std::cos(0.5 * (light.full_angle + light.half_angle)));
}

} // namespace

std::optional<dvec3> position(const SpotLight& light) {
  return light.position;
}

Illumination illumination(const SpotLight& light, const dvec3& point) {
  Illumination seen = illumination_from(light.position, light.falloff, point);
  seen.strength *= brightness_towards(light, -seen.direction);
  return seen;
}

std::optional<LightDisc> disc(const SpotLight&) {
  return std::nullopt;
}

LightReach reach(const SpotLight& light, double value) {
  return reach_from(light.position, light.falloff, value).along(light.axis, light.half_angle, 0.0);
}

double power(const SpotLight& light, double value, double scene_disc) {
  const double angle = solid_angle(light);
  return light.falloff == Falloff::square ? angle * value
                                          : pi * value * scene_disc * std::min(1.0, angle / pi);
}

double brightest(const SpotLight& light, double value, double nearest) {
  return brightest_from(light.falloff, value, nearest);
}

bool endless_flux(const SpotLight& light) {
  return light.falloff == Falloff::none;
}

double aim(const SpotLight& light, double value, EmissionGoals& goals) {
  const Cone cone = cone_of(light);
  std::erase_if(goals.targets, [&](const EmissionTarget& t) {
    return !overlap(cone, cone_to_ball(light.position, t.center, t.radius));
  });
  return value * std::min(cone.solid_angle(), solid_angles(goals.targets, light.position));
}

/// Directions are chosen in the light's cone or towards the targets, whichever is narrower.
std::optional<LightRay> emit(const SpotLight& light, const EmissionGoals& goals,
                             const Sampler& sampler) {
  const Cone cone = cone_of(light);
  const dvec2 u = sampler.pair(kEmissionDirection);
  DirectionSample chosen{};
  if (cone.solid_angle() <= solid_angles(goals.targets, light.position))
    chosen = {cone.sample(u), 1.0 / cone.solid_angle()};
  else
    chosen = towards(goals.targets, light.position, u);
  const double brightness = brightness_towards(light, chosen.direction);
  if (!(brightness > 0.0)) return std::nullopt;
  return LightRay{{light.position, chosen.direction}, brightness / chosen.pdf};
}

} // namespace abbe
