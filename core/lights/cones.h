#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace abbe {

using glm::dvec2;
using glm::dvec3;

/// A cone of directions about a unit axis. The cosine of its half-angle is kept as its distance
/// from 1, which keeps its digits for narrow cones.
struct Cone {
  dvec3 axis{0.0, 0.0, 1.0};
  double one_minus_cosine = 2.0; ///< 2: all directions

  [[nodiscard]] double solid_angle() const;
  [[nodiscard]] bool contains(const dvec3& direction) const;
  /// A direction, uniform in the cone, for two numbers in [0, 1).
  [[nodiscard]] dvec3 sample(const dvec2& u) const;
};

/// The directions from a place to a ball; all of them from inside it.
[[nodiscard]] Cone cone_to_ball(const dvec3& place, const dvec3& center, double radius);

} // namespace abbe
