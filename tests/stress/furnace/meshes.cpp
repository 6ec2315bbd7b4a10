#include "tests/stress/furnace/meshes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace abbe::stress {
namespace {

using Point = std::array<double, 3>;

Triangles octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Each triangle becomes four, with new vertices in the middle of the edges, and all vertices are
/// moved to the unit sphere.
Triangles divided(const Triangles& mesh) {
  Triangles result{mesh.vertices, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
    if (!is_new) return found->second;
    Point m{};
    double length2 = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      m[i] = mesh.vertices[static_cast<std::size_t>(a)][i] +
             mesh.vertices[static_cast<std::size_t>(b)][i];
      length2 += m[i] * m[i];
    }
    for (double& x : m)
      x /= std::sqrt(length2);
    result.vertices.push_back(m);
    return found->second = static_cast<int>(result.vertices.size()) - 1;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return result;
}

/// An octahedron with a pyramid on each of its faces.
Triangles star() {
  const Triangles inner = octahedron();
  Triangles result{inner.vertices, {}};
  for (const auto& [a, b, c] : inner.faces) {
    Point tip{};
    for (const int corner : {a, b, c})
      for (std::size_t i = 0; i < 3; ++i)
        tip[i] += 0.9 * inner.vertices[static_cast<std::size_t>(corner)][i];
    const int t = static_cast<int>(result.vertices.size());
    result.vertices.push_back(tip);
    result.faces.insert(result.faces.end(), {{a, b, t}, {b, c, t}, {c, a, t}});
  }
  for (Point& vertex : result.vertices)
    for (double& x : vertex)
      x *= 0.8;
  return result;
}

Triangles ring() {
  constexpr int kAround = 14, kAcross = 7;
  Triangles result;
  const auto number = [](int i, int j) { return i % kAround * kAcross + j % kAcross; };
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double a = 2.0 * std::numbers::pi * i / kAround;
      const double b = 2.0 * std::numbers::pi * j / kAcross;
      const double radius = 0.7 + 0.3 * std::cos(b);
      result.vertices.push_back({radius * std::cos(a), radius * std::sin(a), 0.3 * std::sin(b)});
      result.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      result.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return result;
}

Triangles wedge() {
  return {{{-1, -1, 0}, {1, -1, 0.01}, {0, 1, 0}, {0, 0, 0.08}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

} // namespace

Triangles named_mesh(std::string_view name) {
  if (name == "ball") return divided(divided(octahedron()));
  if (name == "star") return star();
  if (name == "ring") return ring();
  if (name == "wedge") return wedge();
  return {};
}

void write_meshes(const std::string& folder) {
  for (const char* name : {"ball", "star", "ring", "wedge"}) {
    std::ofstream file(folder + "/" + name + ".obj");
    file.precision(std::numeric_limits<double>::max_digits10);
    const Triangles mesh = named_mesh(name);
    for (const auto& [x, y, z] : mesh.vertices)
      file << "v " << x << ' ' << y << ' ' << z << '\n';
    for (const auto& [a, b, c] : mesh.faces)
      file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
}

} // namespace abbe::stress
