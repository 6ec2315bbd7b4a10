#pragma once

#include "core/optics/frame.h"
#include "geometry/solids/disc_point.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {

using glm::dvec2;

/// The directions within an angle of an axis. The angle is kept by 1 - cos, which is exact for
/// narrow cones too.
struct Cone {
  dvec3 axis{0.0, 0.0, 1.0}; ///< unit
  double one_minus_cos = 0.0;

  /// The cone whose half-angle, up to 90 degrees, has this squared sine.
  [[nodiscard]] static Cone of_sine(const dvec3& axis, double squared_sine) {
    return {axis, squared_sine / (1.0 + std::sqrt(std::max(0.0, 1.0 - squared_sine)))};
  }

  [[nodiscard]] double solid_angle() const { return 2.0 * std::numbers::pi * one_minus_cos; }
  /// Of directions chosen by `sample`, per steradian.
  [[nodiscard]] double pdf() const { return 0.5 * std::numbers::inv_pi / one_minus_cos; }

  /// A unit direction for two numbers in [0, 1), uniform in solid angle: 1 - cos is uniform, as the
  /// squared radius of a disc's points is.
  [[nodiscard]] dvec3 sample(const dvec2& u) const {
    const dvec2 p = disc_point(u);
    const double scale = one_minus_cos * (2.0 - one_minus_cos * glm::dot(p, p));
    return local_direction(p * std::sqrt(scale), one_minus_cos * glm::dot(p, p));
  }

  /// True for unit directions inside. Of v - axis the squared length is 2 (1 - cos).
  [[nodiscard]] bool holds(const dvec3& v) const {
    const dvec3 difference = v - axis;
    return glm::dot(difference, difference) < 2.0 * one_minus_cos;
  }

private:
  [[nodiscard]] dvec3 local_direction(const dvec2& across, double off_axis) const {
    return Frame(axis).to_world({across.x, across.y, 1.0 - off_axis});
  }
};

/// The directions from a place to a ball; all of them from inside it.
[[nodiscard]] inline Cone cone_to_ball(const dvec3& place, const dvec3& centre, double radius) {
  const dvec3 way = centre - place;
  const double distance = glm::length(way);
  if (!(distance > radius)) return {{0.0, 0.0, 1.0}, 2.0};
  const double sine = radius / distance;
  return Cone::of_sine(way / distance, sine * sine);
}

} // namespace abbe
