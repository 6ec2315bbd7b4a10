#pragma once

#include "geometry/meshes/mesh.h"
#include "tests/geometry/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace abbe::reference {

/// A ring of `around` x `about` quads, each two triangles: concave, with a hole. Its tube has the
/// radius 0.5 `width` across and 0.5 `height` along the axis.
inline Mesh torus(int around, int about, double width = 1.0, double height = 1.0) {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;
  const auto number = [&](int i, int k) { return (i % around) * about + k % about; };
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < about; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / about;
      const double r = 1.0 + 0.5 * width * std::cos(v);
      vertices.emplace_back(r * std::cos(u), r * std::sin(u), 0.5 * height * std::sin(v));
      const std::int32_t a = number(i, k), b = number(i + 1, k), c = number(i + 1, k + 1),
                         d = number(i, k + 1);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return {vertices, triangles};
}

/// A ball of radius 1: an icosahedron, each triangle cut into four `levels` times.
inline Mesh icosphere(int levels) {
  const double g = std::numbers::phi;
  std::vector<dvec3> vertices{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                              {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                              {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Triangle> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const auto middle = [&](std::int32_t p, std::int32_t q) {
        const auto i = static_cast<std::size_t>(std::min(p, q));
        const auto k = static_cast<std::size_t>(std::max(p, q));
        vertices.push_back(vertices[i] + vertices[k]); // Mesh makes the edge's two middles one
        vertices.back() *= glm::length(vertices[0]) / glm::length(vertices.back());
        return static_cast<std::int32_t>(vertices.size()) - 1;
      };
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(t);
    }
    triangles = finer;
  }
  for (dvec3& v : vertices)
    v /= glm::length(dvec3(1, g, 0));
  return {vertices, triangles};
}

/// The triangles of a mesh in the world, in 80-bit arithmetic.
struct Soup {
  std::vector<std::array<Vec, 3>> triangles;

  Soup(const Mesh& mesh, const glm::dmat3& linear, const dvec3& offset) {
    for (int i = 0; i < static_cast<int>(mesh.triangles().size()); ++i) {
      std::array<Vec, 3> corners{};
      for (int c = 0; c < 3; ++c)
        corners[static_cast<std::size_t>(c)] = Mat(linear) * Vec(mesh.corner(i, c)) + Vec(offset);
      triangles.push_back(corners);
    }
  }

  /// The first crossing ahead by Cramer's rule, and how close it or a near miss is to an edge.
  struct First {
    Real t = INFINITY, cosine = 1, edge = INFINITY;
    int triangle = -1;
  };
  [[nodiscard]] First first(const Vec& o, const Vec& d) const {
    First found;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [a, b, c] = triangles[i];
      const Vec n = glm::cross(b - a, c - a);
      const Real speed = glm::dot(n, d);
      const Real t = glm::dot(n, a - o) / speed;
      const Vec p = o + t * d;
      const Real u = glm::dot(n, glm::cross(b - p, c - p)) / glm::dot(n, n);
      const Real v = glm::dot(n, glm::cross(c - p, a - p)) / glm::dot(n, n);
      const Real least = std::min({u, v, 1 - u - v});
      if (t > 0) found.edge = std::min(found.edge, std::abs(least));
      if (least < 0 || t <= 0 || t >= found.t) continue;
      found.t = t;
      found.cosine = std::abs(speed) / glm::length(n);
      found.triangle = static_cast<int>(i);
    }
    return found;
  }
  /// The winding number about a point: 1 inside, 0 outside; empty close to the surface.
  [[nodiscard]] std::optional<bool> contains(const Vec& p) const {
    Real angle = 0;
    for (const auto& t : triangles) {
      const Vec a = t[0] - p, b = t[1] - p, c = t[2] - p;
      const Real la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const Real volume = glm::dot(a, glm::cross(b, c));
      const Vec n = glm::cross(b - a, c - a);
      if (std::abs(volume) < 1e-9L * glm::length(n) && la + lb + lc < 6) return std::nullopt;
      angle += 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                          glm::dot(c, a) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi_v<Real>;
  }
};

} // namespace abbe::reference
