#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace abbe {

using glm::dvec3;

/// An orthonormal frame about a unit vector `z` [Duff17].
struct Frame {
  dvec3 x, y, z;

  explicit Frame(const dvec3& axis) : z(axis) {
    const double sign = std::copysign(1.0, z.z);
    const double a = -1.0 / (sign + z.z);
    const double b = z.x * z.y * a;
    x = {1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x};
    y = {b, sign + z.y * z.y * a, -z.y};
  }

  [[nodiscard]] dvec3 to_local(const dvec3& v) const {
    return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
  }
  [[nodiscard]] dvec3 to_world(const dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

} // namespace abbe
