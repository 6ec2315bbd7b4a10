#pragma once

#include "geometry/solids/circle_point.h"

#include <cmath>
#include <numbers>

namespace abbe {

/// A point of the unit disc for two numbers in [0, 1), uniform in area: squares become rings of
/// equal area, which keep strata together [Shirley97].
[[nodiscard]] inline dvec2 disc_point(const dvec2& u) {
  const dvec2 d = 2.0 * u - 1.0;
  if (d.x == 0.0 && d.y == 0.0) return d;
  constexpr double kEighth = std::numbers::pi / 4.0;
  const bool by_x = std::abs(d.x) > std::abs(d.y);
  const double radius = by_x ? d.x : d.y, across = by_x ? d.y : d.x;
  const dvec2 p = radius * small_angle_point(kEighth * (across / radius));
  return by_x ? p : dvec2(p.y, p.x);
}

} // namespace abbe
