#pragma once

#include "io/meshes/polygons.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace abbe::test {

/// Vertices of any magnitude, with all their digits, and polygons of any of them. With `single`,
/// coordinates are numbers of single precision.
inline Polygons random_polygons(std::mt19937_64& random, bool single) {
  const auto below = [&](int end) {
    return std::uniform_int_distribution<int>(0, end - 1)(random);
  };
  Polygons mesh;
  const int vertices = 3 + below(40);
  const int widest = single ? 120 : 300;
  for (int i = 0; i < vertices; ++i) {
    glm::dvec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      const double digits = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
      p[axis] = std::ldexp(digits, below(8) == 0 ? below(2 * widest) - widest : 0);
      if (below(20) == 0) p[axis] = below(2) == 0 ? -0.0 : below(10);
      if (single) p[axis] = static_cast<float>(p[axis]);
    }
    mesh.vertices.push_back(p);
  }
  const int polygons = 1 + below(30);
  for (int i = 0; i < polygons; ++i) {
    for (int corner = 3 + below(5); corner > 0; --corner)
      mesh.corners.push_back(below(vertices));
    mesh.ends.push_back(mesh.corners.size());
  }
  return mesh;
}

/// True for equal meshes of equal coordinates, bit by bit.
inline bool same(const Polygons& a, const Polygons& b) {
  if (a.corners != b.corners || a.ends != b.ends || a.vertices.size() != b.vertices.size())
    return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (std::bit_cast<std::uint64_t>(a.vertices[i][axis]) !=
          std::bit_cast<std::uint64_t>(b.vertices[i][axis]))
        return false;
  return true;
}

} // namespace abbe::test
