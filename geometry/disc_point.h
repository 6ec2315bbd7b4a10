#pragma once

#include <glm/vec2.hpp>

#include <cmath>
#include <numbers>

namespace abbe {

using glm::dvec2;

/// A point of the unit disc for two numbers in [0, 1), uniform in area: squares become rings of
/// equal area, which keep strata together [Shirley97].
[[nodiscard]] inline dvec2 disc_point(const dvec2& u) {
  const dvec2 d = 2.0 * u - 1.0;
  if (d.x == 0.0 && d.y == 0.0) return d;
  constexpr double kEighth = std::numbers::pi / 4.0;
  const bool by_x = std::abs(d.x) > std::abs(d.y);
  const double radius = by_x ? d.x : d.y;
  const double angle = by_x ? kEighth * (d.y / d.x) : 2.0 * kEighth - kEighth * (d.x / d.y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace abbe
