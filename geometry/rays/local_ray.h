#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/transform.h"
#include "geometry/rays/wide.h"

#include <cmath>

namespace abbe {

/// A ray in a shape's own frame, with bounds on the rounding errors of its two vectors; solvers
/// turn them into the error of the t they return.
struct LocalRay {
  dvec3 origin{0.0};
  dvec3 direction{0.0, 0.0, 1.0};
  double coordinate_error = 0.0; ///< of the origin, and of the shape's own coordinates
  double direction_error = 0.0;

  [[nodiscard]] dvec3 at(double t) const { return origin + t * direction; }

  /// How far off its place a surface may seem that the line meets at `t`: the errors of the ray
  /// there, and those of the few sums in the surface's equation, whose terms are no larger than
  /// the shape (`size`), the origin's distance and the distance to the place together.
  [[nodiscard]] double shift_at(double t, double size) const {
    const double reach = size + sum(origin) + std::abs(t) * sum(direction);
    return coordinate_error + std::abs(t) * direction_error + 8.0 * kRoundoff * reach;
  }
  /// By how much `shift_at` grows with each unit of t.
  [[nodiscard]] double shift_rate() const {
    return direction_error + 8.0 * kRoundoff * sum(direction);
  }

private:
  [[nodiscard]] static double sum(const dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  }
};

/// Whether a direction (of any length) runs against a unit normal, by more than the rounding of
/// one that was made to run along the face. A ray along a face may leave by it.
[[nodiscard]] inline bool runs_in(const dvec3& normal, const dvec3& direction) {
  return glm::dot(normal, direction) < -64.0 * kRoundoff * glm::length(direction);
}

/// `ray` seen from the frame that `to_outer` maps to the ray's; t keeps its meaning.
[[nodiscard]] inline LocalRay local_ray(const Transform& to_outer, const LocalRay& ray) {
  return {to_outer.inverse_point(ray.origin), to_outer.inverse_vector(ray.direction),
          to_outer.inverse_error(ray.origin, ray.coordinate_error),
          to_outer.inverse_vector_error(ray.direction, ray.direction_error)};
}

/// A LocalRay, or what serves as one: solvers take either.
template <class R>
concept RayInFrame = requires(const R& ray) {
  ray.origin.x + ray.direction.x + ray.at(0.0).x + ray.shift_at(0.0, 1.0);
};

[[nodiscard]] Wide wide_origin(const RayInFrame auto& ray) {
  return Wide{ray.origin.x, ray.origin.y, ray.origin.z, 0.0};
}
[[nodiscard]] Wide wide_direction(const RayInFrame auto& ray) {
  return Wide{ray.direction.x, ray.direction.y, ray.direction.z, 0.0};
}

/// The rounding error of a root t with a plane: a plane shifted by e that the line crosses at
/// `speed` = |n.d| moves its root by e / speed; forming t rounds a few times more. The shift grows
/// with t. Where it grows as fast as the line comes near, the plane may never be met, but not
/// sooner than where their sum has covered the distance: e = c + r t moves t to
/// (t speed - c) / (speed + r), by e / (speed + r).
[[nodiscard]] double plane_root_error(const RayInFrame auto& ray, double speed, double t,
                                      double size) {
  return ray.shift_at(t, size) / (speed + ray.shift_rate()) + 4.0 * kRoundoff * std::abs(t);
}

} // namespace abbe
