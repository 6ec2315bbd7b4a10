#include "core/lights/illumination.h"

#include <glm/geometric.hpp>

#include <limits>
#include <numbers>

namespace abbe {

Illumination illumination_from(const dvec3& position, Falloff falloff, const dvec3& point) {
  const dvec3 to_light = position - point;
  const double distance = glm::length(to_light);
  if (!(distance > 0.0)) return {};
  const double strength =
      falloff == Falloff::none ? 1.0 : std::numbers::inv_pi / (distance * distance);
  return {to_light / distance, distance, strength};
}

Illumination illumination_along(const dvec3& direction) {
  return {-direction, std::numeric_limits<double>::infinity(), 1.0};
}

double brightest_from(Falloff falloff, double value, double nearest) {
  if (falloff == Falloff::none) return value;
  return nearest > 0.0 ? value / (nearest * nearest) : 0.0;
}

} // namespace abbe
