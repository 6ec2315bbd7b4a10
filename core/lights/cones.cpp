#include "core/lights/cones.h"

#include "core/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {

double Cone::solid_angle() const {
  return 2.0 * std::numbers::pi * one_minus_cosine;
}

bool Cone::contains(const dvec3& direction) const {
  // |a - b|^2 = 2 (1 - cos) for unit vectors.
  const dvec3 apart = direction - axis;
  return glm::dot(apart, apart) <= 2.0 * one_minus_cosine;
}

dvec3 Cone::sample(const dvec2& u) const {
  const double below = u.x * one_minus_cosine; // 1 - cos of the direction's angle
  const double radius = std::sqrt(std::max(0.0, below * (2.0 - below)));
  const double angle = 2.0 * std::numbers::pi * u.y;
  return glm::normalize(
      Frame(axis).to_world({radius * std::cos(angle), radius * std::sin(angle), 1.0 - below}));
}

Cone cone_to_ball(const dvec3& place, const dvec3& center, double radius) {
  const dvec3 way = center - place;
  const double distance = glm::length(way);
  if (!(distance > radius)) return {};
  const double sine = radius / distance;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  return {way / distance, sine * sine / (1.0 + cosine)};
}

} // namespace abbe
