#pragma once

#include "geometry/rays/transform.h"

namespace abbe {

/// All points within a distance of a place.
struct BoundingBall {
  dvec3 center{0.0};
  double radius = 0.0;
};

/// A ball that holds the unit ball's image; its image itself under a similarity.
[[nodiscard]] BoundingBall image_of_unit_ball(const Transform& map);

/// A ball that holds what two have in common. Two that overlap by less than half have a lens in
/// common, which lies in the ball about the circle where their surfaces meet.
[[nodiscard]] BoundingBall ball_around_common(const BoundingBall& a, const BoundingBall& b);

} // namespace abbe
