#include "geometry/booleans/bounding_ball.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace abbe {

BoundingBall image_of_unit_ball(const Transform& map) {
  const std::array<dvec3, 3> axes{map.vector({1.0, 0.0, 0.0}), map.vector({0.0, 1.0, 0.0}),
                                  map.vector({0.0, 0.0, 1.0})};
  // No direction is stretched by more than the root of the largest eigenvalue of M^T M, and that
  // eigenvalue is at most the largest sum of a row's magnitudes [Gershgorin31].
  double most = 0.0;
  for (const dvec3& x : axes) {
    double sum = 0.0;
    for (const dvec3& y : axes)
      sum += std::abs(glm::dot(x, y));
    most = std::max(most, sum);
  }
  return {map.point(dvec3(0.0)), std::sqrt(most)};
}

BoundingBall ball_around_common(const BoundingBall& a, const BoundingBall& b) {
  const BoundingBall& smaller = a.radius < b.radius ? a : b;
  const dvec3 separation = b.center - a.center;
  const double distance = glm::length(separation);
  if (!(distance > 0.0)) return smaller;
  // The circle's plane lies so far from a's centre.
  const double height = 0.5 * (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance);
  if (height < 0.0 || height > distance) return smaller; // it is not between the centres
  const double radius2 = (a.radius - height) * (a.radius + height);
  return {a.center + separation * (height / distance), std::sqrt(std::max(0.0, radius2))};
}

} // namespace abbe
