#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/local_ray.h"
#include "geometry/rays/transform.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace abbe {

/// The ball of radius 1 about the origin of its frame. It has one face, number 0.
struct Sphere {};

/// The rounding error of two roots that lie `cosine` before and behind the line's middle. A
/// surface shifted by e changes cosine^2 = 1 - height^2 by 2 e, and the roots by
/// |sqrt(D) - sqrt(D +- 2 e)| <= 2 e / max(sqrt(D), sqrt(2 e)): where the line only grazes, the
/// error is that of a square root.
[[nodiscard]] double sphere_root_error(const RayInFrame auto& ray, double speed, double cosine,
                                       double farther_t) {
  const double change = 2.0 * ray.shift_at(farther_t, 1.0);
  return change / (speed * std::max(cosine, std::sqrt(change))) +
         4.0 * kRoundoff * std::abs(farther_t);
}

/// The part of the ray's line inside the ball. With a contact the root of the surface is t = 0.
[[nodiscard]] std::optional<Interval> intersect(const Sphere&, const RayInFrame auto& ray,
                                                const FaceContact* contact = nullptr) {
  // |o + t d|^2 = 1 is a t^2 + 2 b t + c = 0.
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(ray.origin, ray.direction);
  const double speed = std::sqrt(a);

  if (contact) {
    if (contact->side == Side::outside) return std::nullopt; // convex: never met again
    const double t = std::max(0.0, -2.0 * b / a);            // c is 0 exactly
    return Interval{{0.0, 0.0, {}}, {t, sphere_root_error(ray, speed, std::abs(b) / speed, t), {}}};
  }

  // The discriminant from the point of closest approach does not cancel for far origins.
  const dvec3 closest = ray.origin - (b / a) * ray.direction;
  const double discriminant = 1.0 - glm::dot(closest, closest);
  if (discriminant < 0.0) return std::nullopt;
  const double cosine = std::sqrt(discriminant);
  const double half = speed * cosine;
  const double c = glm::dot(ray.origin, ray.origin) - 1.0;
  const double q = b > 0.0 ? -b - half : -b + half; // the sum that does not cancel
  double t0 = q / a;
  double t1 = q != 0.0 ? c / q : t0;
  if (t0 > t1) std::swap(t0, t1);
  const double error = sphere_root_error(ray, speed, cosine, std::max(std::abs(t0), std::abs(t1)));
  return Interval{{t0, error, {}}, {t1, error, {}}};
}

[[nodiscard]] inline dvec3 outward_normal(const Sphere&, const dvec3& point, int) {
  return point;
}
/// The nearest point of the surface to a point known to lie on it but for rounding.
[[nodiscard]] inline dvec3 snapped(const Sphere&, const dvec3& point, int) {
  return point / glm::length(point);
}
[[nodiscard]] int nearest_face(const Sphere& sphere, const dvec3& point, const dvec3& direction);
/// Negative inside, positive outside, zero on the surface; near the surface it is the distance.
[[nodiscard]] double signed_distance(const Sphere& sphere, const dvec3& point);
[[nodiscard]] Bounds bounds(const Sphere& sphere, const Transform& to_world);

} // namespace abbe
