#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace abbe {

using glm::dvec2;

/// (cos a, sin a) for |a| <= pi / 4, by Taylor's series, cut off where they no longer reach a
/// double's last place. No call, and the same bits whatever the C library.
[[nodiscard]] inline dvec2 small_angle_point(double a) {
  const double a2 = a * a;
  // 1 / k! for even and odd k, highest first
  double c = 1.0 / 20922789888000.0;
  c = c * a2 - 1.0 / 87178291200.0;
  c = c * a2 + 1.0 / 479001600.0;
  c = c * a2 - 1.0 / 3628800.0;
  c = c * a2 + 1.0 / 40320.0;
  c = c * a2 - 1.0 / 720.0;
  c = c * a2 + 1.0 / 24.0;
  c = c * a2 - 0.5;
  double s = -1.0 / 1307674368000.0;
  s = s * a2 + 1.0 / 6227020800.0;
  s = s * a2 - 1.0 / 39916800.0;
  s = s * a2 + 1.0 / 362880.0;
  s = s * a2 - 1.0 / 5040.0;
  s = s * a2 + 1.0 / 120.0;
  s = s * a2 - 1.0 / 6.0;
  return {1.0 + a2 * c, a + a * (a2 * s)};
}

/// The point of the unit circle after so many turns, fewer than 2^29, counter-clockwise from (1,
/// 0).
[[nodiscard]] inline dvec2 circle_point(double turns) {
  constexpr double kQuarter = 1.57079632679489661923;
  const double quarters = 4.0 * turns;
  const double whole = std::floor(quarters + 0.5);
  const dvec2 p = small_angle_point(kQuarter * (quarters - whole));
  switch (static_cast<int>(whole) & 3) {
  case 0:
    return p;
  case 1:
    return {-p.y, p.x};
  case 2:
    return -p;
  default:
    return {p.y, -p.x};
  }
}

/// The magnitude of the sine after so many turns, fewer than 2^52, without a branch: loops of it go
/// several at once. It is exact to the last places near a whole turn too.
[[nodiscard]] inline double sine_of_turns(double turns) {
  constexpr double kTurn = 6.28318530717958647693;
  const double r = std::abs(turns - std::floor(turns + 0.5)); // from the nearest whole turn
  const double a = kTurn * std::min(r, 0.5 - r);
  const double a2 = a * a;
  double s = 1.0 / 51090942171709440000.0;
  s = s * a2 - 1.0 / 121645100408832000.0;
  s = s * a2 + 1.0 / 355687428096000.0;
  s = s * a2 - 1.0 / 1307674368000.0;
  s = s * a2 + 1.0 / 6227020800.0;
  s = s * a2 - 1.0 / 39916800.0;
  s = s * a2 + 1.0 / 362880.0;
  s = s * a2 - 1.0 / 5040.0;
  s = s * a2 + 1.0 / 120.0;
  s = s * a2 - 1.0 / 6.0;
  return a + a * (a2 * s);
}

} // namespace abbe
