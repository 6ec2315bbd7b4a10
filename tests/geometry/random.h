#pragma once

#include "geometry/solids/polyhedron.h"
#include "tests/geometry/reference.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace abbe::reference {

/// Random numbers that are the same with every standard library.
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  [[nodiscard]] int below(int count) { return static_cast<int>(uniform(0.0, count)); }
  [[nodiscard]] bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  [[nodiscard]] dvec3 in_cube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  [[nodiscard]] dvec3 direction() {
    while (true) {
      const dvec3 v = in_cube(1.0);
      const double length = glm::length(v);
      if (length < 1.0 && length > 0.1) return v / length;
    }
  }
  [[nodiscard]] glm::dmat3 rotation() {
    const dvec3 x = direction();
    const dvec3 z = glm::normalize(glm::cross(x, direction()));
    return {x, glm::cross(z, x), z};
  }
  /// Rotation, three scales a factor of nine apart at most, another rotation, one in two mirrored.
  [[nodiscard]] glm::dmat3 linear() {
    glm::dmat3 scale(0.0);
    for (int i = 0; i < 3; ++i)
      scale[i][i] = std::exp(uniform(std::log(1.0 / 3), std::log(3.0)));
    if (chance(0.5)) scale[0][0] = -scale[0][0];
    const glm::dmat3 inner = rotation();
    return rotation() * scale * inner;
  }
  /// Planes at 0.5 to 1.5 from the origin. Six near the axes close the solid, the others cut it.
  [[nodiscard]] std::vector<HalfSpace> planes(int count) {
    std::vector<HalfSpace> found;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        dvec3 n = in_cube(0.3);
        n[axis] = sign;
        found.push_back({glm::normalize(n), uniform(0.5, 1.5)});
      }
    while (static_cast<int>(found.size()) < count)
      found.push_back({direction(), uniform(0.5, 1.5)});
    return found;
  }

private:
  std::mt19937_64 engine_;
};

/// A lens: the part common to two unit balls whose centres are 2 `half` apart along z.
[[nodiscard]] inline Piece lens_piece(double half) {
  const glm::dmat3 one(1.0);
  return combined(CsgOperation::intersect, piece(placed(sphere(), one, {0, 0, half})),
                  piece(placed(sphere(), one, {0, 0, -half})));
}

/// (lens + prism) - (box & (sphere - sphere)), leaves under random affine maps.
[[nodiscard]] inline Piece nested_piece(Random& random) {
  using enum CsgOperation;
  const auto leaf = [&](const Twin& twin) {
    return piece(placed(twin, random.linear(), random.in_cube(0.5)));
  };
  const Piece hollow = combined(subtract, leaf(sphere()), leaf(sphere()));
  const Piece carved = combined(intersect, leaf(box()), hollow);
  return combined(subtract, combined(unite, lens_piece(0.3), leaf(prism())), carved);
}

} // namespace abbe::reference
