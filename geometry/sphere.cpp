#include "geometry/sphere.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// A root's rounding error: the surface is missed by `coordinate_error` and a few roundings of
/// coordinates, and a shift of the surface by e moves the root by e / (speed * cosine).
double root_error(const LocalRay& ray, double speed, double cosine, double t) {
  const double reach = 1.0 + glm::length(ray.origin);
  const double shift = ray.coordinate_error + 16.0 * kRoundoff * reach;
  // At grazing incidence the two roots merge; their error is then that of a square root.
  return shift / (speed * std::max(cosine, std::sqrt(shift))) + 4.0 * kRoundoff * std::abs(t);
}

} // namespace

std::optional<Interval> intersect(const Sphere&, const LocalRay& ray, const FaceContact* contact) {
  // |o + t d|^2 = 1 is a t^2 + 2 b t + c = 0.
  const double a = glm::dot(ray.direction, ray.direction);
  const double b = glm::dot(ray.origin, ray.direction);
  const double speed = std::sqrt(a);

  if (contact) {
    if (contact->side == Side::outside) return std::nullopt; // convex: never met again
    const double t = std::max(0.0, -2.0 * b / a);            // c is 0 exactly
    return Interval{{0.0, 0.0, {}}, {t, root_error(ray, speed, std::abs(b) / speed, t), {}}};
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
  return Interval{{t0, root_error(ray, speed, cosine, t0), {}},
                  {t1, root_error(ray, speed, cosine, t1), {}}};
}

dvec3 outward_normal(const Sphere&, const dvec3& point, int) {
  return point;
}

dvec3 snapped(const Sphere&, const dvec3& point, int) {
  return point / glm::length(point);
}

int nearest_face(const Sphere&, const dvec3&) {
  return 0;
}

double signed_distance(const Sphere&, const dvec3& point) {
  return glm::length(point) - 1.0;
}

Bounds bounds(const Sphere&, const Transform& to_world) {
  return to_world.unit_sphere_box();
}

} // namespace abbe
