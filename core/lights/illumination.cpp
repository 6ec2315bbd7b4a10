#include "core/lights/illumination.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {
namespace {

Illumination from_position(const dvec3& position, Falloff falloff, const dvec3& point) {
  const dvec3 way = position - point;
  const double distance = glm::length(way);
  if (!(distance > 0.0)) return {};
  const double strength =
      falloff == Falloff::none ? 1.0 : std::numbers::inv_pi / (distance * distance);
  return {way / distance, distance, strength};
}

Illumination seen(const PointLight& lamp, Falloff falloff, const dvec3& point) {
  return from_position(lamp.position, falloff, point);
}

Illumination seen(const DirectionalLight& lamp, Falloff, const dvec3&) {
  return {-lamp.direction, std::numeric_limits<double>::infinity(), 1.0};
}

Illumination seen(const SunLight& lamp, Falloff, const dvec3&) {
  return {-lamp.direction, std::numeric_limits<double>::infinity(), 1.0};
}

Illumination seen(const SpotLight& lamp, Falloff falloff, const dvec3& point) {
  Illumination light = from_position(lamp.position, falloff, point);
  const double angle = std::acos(std::clamp(-glm::dot(light.direction, lamp.axis), -1.0, 1.0));
  if (angle >= lamp.half_angle) {
    light.strength = 0.0;
  } else if (angle > lamp.full_angle) {
    const double x = (lamp.half_angle - angle) / (lamp.half_angle - lamp.full_angle);
    light.strength *= x * x * (3.0 - 2.0 * x); // the smooth step
  }
  return light;
}

} // namespace

Illumination illumination(const Light& light, const dvec3& point) {
  return std::visit([&](const auto& lamp) { return seen(lamp, light.falloff, point); },
                    light.emitter);
}

} // namespace abbe
