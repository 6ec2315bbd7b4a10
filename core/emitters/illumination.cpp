#include "core/emitters/illumination.h"

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
  light.strength *= brightness_towards(lamp, -light.direction);
  return light;
}

} // namespace

double brightness_towards(const SpotLight& spot, const dvec3& direction) {
  const double angle = std::acos(std::clamp(glm::dot(direction, spot.axis), -1.0, 1.0));
  if (angle >= spot.half_angle) return 0.0;
  if (angle <= spot.full_angle) return 1.0;
  const double x = (spot.half_angle - angle) / (spot.half_angle - spot.full_angle);
  return x * x * (3.0 - 2.0 * x); // the smooth step
}

Illumination illumination(const Light& light, const dvec3& point) {
  return std::visit([&](const auto& lamp) { return seen(lamp, light.falloff, point); },
                    light.emitter);
}

} // namespace abbe
