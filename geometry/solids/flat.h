#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/local_ray.h"
#include "geometry/rays/transform.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

namespace abbe {

// Flat shapes lie in the plane z = 0 of their frame. They have no inside; their normal is +z.

struct Square {}; ///< from -1 to 1 in x and y
struct Disc {};   ///< of radius 1 about the origin
struct Plane {};  ///< without end

using Flat = std::variant<Square, Disc, Plane>;

/// True for the types that Flat holds.
template <class S>
concept FlatShape = requires(const S& shape, const dvec3& point) { covers(shape, point); };

/// Whether the shape holds this point of its plane.
[[nodiscard]] inline bool covers(const Square&, const dvec3& point) {
  return std::abs(point.x) <= 1.0 && std::abs(point.y) <= 1.0;
}
[[nodiscard]] inline bool covers(const Disc&, const dvec3& point) {
  return point.x * point.x + point.y * point.y <= 1.0;
}
[[nodiscard]] inline bool covers(const Plane&, const dvec3&) {
  return true;
}

/// The root `t` of a plane without end whose bound of error is more than half of it: nothing is
/// known of the root but that the plane is not met before a distance `nearest` (see
/// plane_root_error). That is the difference of t and its bound, whose digits cancel where t is
/// large; so it is computed by itself, and the root is put at twice as much, where its bound has
/// digits again.
[[nodiscard]] Root root_without_digits(const RayInFrame auto& ray, double t, double error) {
  const double height = std::abs(ray.origin.z) - ray.shift_at(0.0, 1.0);
  const double nearest = height / (std::abs(ray.direction.z) + ray.shift_rate());
  if (!(2.0 * nearest > 0.0 && 2.0 * nearest < std::abs(t))) return {t, error, {}};
  return {std::copysign(2.0 * nearest, t), nearest, {}};
}

/// Where a line meets the shape between `first` and `last`, that one not included. Nothing for a
/// line in the shape's plane, which sees no area of it.
template <FlatShape S>
[[nodiscard]] std::optional<Root> intersect(const S& shape, const RayInFrame auto& ray,
                                            double first = -kInfinity, double last = kInfinity) {
  if (ray.direction.z == 0.0) return std::nullopt;
  const double t = -ray.origin.z / ray.direction.z;
  if (t < first || t >= last || !covers(shape, ray.at(t))) return std::nullopt;
  const double error = plane_root_error(ray, std::abs(ray.direction.z), t, 1.0);
  if constexpr (std::is_same_v<S, Plane>)
    if (error > 0.5 * std::abs(t)) [[unlikely]]
      return root_without_digits(ray, t, error);
  return Root{t, error, {}};
}

template <FlatShape S>
[[nodiscard]] dvec3 outward_normal(const S&, const dvec3&, int) {
  return {0.0, 0.0, 1.0};
}

template <FlatShape S>
[[nodiscard]] dvec3 snapped(const S&, const dvec3& point, int) {
  return {point.x, point.y, 0.0};
}

[[nodiscard]] Bounds bounds(const Square& square, const Transform& to_world);
[[nodiscard]] Bounds bounds(const Disc& disc, const Transform& to_world);
/// Everywhere, as far as Embree goes (it drops what reaches beyond 1.8e18): a plane is asked for
/// each ray. The box is off the middle, so that Embree's builder parts it from all other shapes
/// at once.
[[nodiscard]] Bounds bounds(const Plane& plane, const Transform& to_world);

} // namespace abbe
