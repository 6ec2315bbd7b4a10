#include "geometry/meshes/seams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace abbe {
namespace {

using Sides = std::vector<TriangleSide>;

/// One side of each edge of an odd number of triangles.
Sides border_of(std::size_t vertex_count, const std::vector<Triangle>& triangles) {
  Sides border;
  EdgeTable(vertex_count, triangles).for_each_edge([&](std::span<const TriangleSide> edge) {
    if (edge.size() % 2 != 0) border.push_back(edge[0]);
  });
  return border;
}

/// Numbers of vertices by the cell of a grid that they lie in.
class Cells {
public:
  explicit Cells(double width) : width_(width) {}

  /// The first vertex added that is no farther than a cell's width from p.
  [[nodiscard]] std::optional<std::int32_t> near(const std::vector<dvec3>& vertices,
                                                 const dvec3& p) const {
    std::optional<std::int32_t> found;
    for (int i = 0; i < 27; ++i) {
      const dvec3 shift(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const auto [begin, end] = cells_.equal_range(number(p / width_ + shift));
      for (auto cell = begin; cell != end; ++cell) {
        const bool close =
            glm::length(vertices[static_cast<std::size_t>(cell->second)] - p) <= width_;
        if (close && (!found || cell->second < *found)) found = cell->second;
      }
    }
    return found;
  }
  void add(const dvec3& p, std::int32_t vertex) { cells_.emplace(number(p / width_), vertex); }

private:
  static std::uint64_t number(const dvec3& cell) {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) { // the factor is an odd number near 2^64 / phi
      h = (h ^ static_cast<std::uint64_t>(std::llround(std::floor(cell[i])))) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }

  double width_;
  std::unordered_multimap<std::uint64_t, std::int32_t> cells_;
};

/// Makes vertices of the border one where they lie within the tolerance.
std::size_t weld(const std::vector<dvec3>& vertices, std::vector<Triangle>& triangles,
                 double tolerance) {
  std::vector<std::int32_t> ends;
  for (const TriangleSide& side : border_of(vertices.size(), triangles)) {
    ends.push_back(side.lower);
    ends.push_back(side.upper);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<std::int32_t> becomes(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    becomes[v] = static_cast<std::int32_t>(v);
  Cells cells(tolerance);
  std::size_t welded = 0;
  for (const std::int32_t v : ends) {
    const dvec3& p = vertices[static_cast<std::size_t>(v)];
    if (const auto other = cells.near(vertices, p)) {
      becomes[static_cast<std::size_t>(v)] = *other;
      ++welded;
    } else {
      cells.add(p, v);
    }
  }
  for (Triangle& t : triangles)
    for (std::int32_t& corner : t)
      corner = becomes[static_cast<std::size_t>(corner)];
  return welded;
}

/// Drops triangles of which two corners are one vertex, and those that repeat another. Returns how
/// many the latter were.
std::size_t tidy(std::vector<Triangle>& triangles, Repetition dropped_kind) {
  std::erase_if(triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const std::vector<bool> again = repeated(triangles, dropped_kind);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (!again[i]) triangles[kept++] = triangles[i];
  const std::size_t dropped = triangles.size() - kept;
  triangles.resize(kept);
  return dropped;
}

/// The border of a mesh, seen from its vertices.
class Border {
public:
  Border(const std::vector<dvec3>& vertices, const Sides& sides) : vertices_(vertices) {
    for (const TriangleSide& side : sides) {
      ways_.emplace_back(side.lower, side.upper);
      ways_.emplace_back(side.upper, side.lower);
    }
    std::sort(ways_.begin(), ways_.end());
  }

  /// The vertices that lie on the line between two others and that the border reaches from either
  /// of them without leaving it, in their order. The triangle's third corner is none of them.
  [[nodiscard]] std::vector<std::int32_t> between(std::int32_t from, std::int32_t to,
                                                  std::int32_t third, double tolerance) const {
    std::vector<std::pair<double, std::int32_t>> found;
    const dvec3& a = at(from);
    const dvec3 along = at(to) - a;
    const double length = glm::length(along);
    const auto reach = [&](std::int32_t start, double sign) {
      std::int32_t here = start;
      double place = sign > 0.0 ? 0.0 : length;
      for (bool goes_on = true; goes_on;) {
        goes_on = false;
        std::pair<double, std::int32_t> next(sign > 0.0 ? length : 0.0, -1);
        auto way = std::lower_bound(ways_.begin(), ways_.end(), std::pair(here, std::int32_t{-1}));
        for (; way != ways_.end() && way->first == here; ++way) {
          const std::int32_t v = way->second;
          if (v == third || v == from || v == to) continue;
          const double x = glm::dot(at(v) - a, along) / length;
          const bool ahead = sign * (x - place) > tolerance && sign * (next.first - x) > tolerance;
          if (!ahead || glm::length(at(v) - a - x / length * along) > tolerance) continue;
          next = {x, v};
        }
        if (next.second < 0) continue;
        found.push_back(next);
        std::tie(place, here) = next;
        goes_on = true;
      }
    };
    reach(from, 1.0);
    reach(to, -1.0);
    std::sort(found.begin(), found.end());
    std::vector<std::int32_t> order;
    for (const auto& [x, v] : found)
      if (order.empty() || order.back() != v) order.push_back(v);
    return order;
  }

private:
  [[nodiscard]] const dvec3& at(std::int32_t v) const {
    return vertices_[static_cast<std::size_t>(v)];
  }

  const std::vector<dvec3>& vertices_;
  std::vector<std::pair<std::int32_t, std::int32_t>> ways_; ///< from one vertex to another
};

/// Splits the triangles on whose edges vertices of the border lie, each at one edge. Returns how
/// many it was.
std::size_t split(const std::vector<dvec3>& vertices, std::vector<Triangle>& triangles,
                  double tolerance) {
  const Sides sides = border_of(vertices.size(), triangles);
  const Border border(vertices, sides);
  std::vector<bool> changed(triangles.size(), false);
  std::size_t count = 0;
  for (const TriangleSide& side : sides) {
    const auto t = static_cast<std::size_t>(side.triangle), i = static_cast<std::size_t>(side.side);
    if (changed[t]) continue;
    const auto [from, to, third] =
        Triangle{triangles[t][i], triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]};
    const std::vector<std::int32_t> between = border.between(from, to, third, tolerance);
    if (between.empty()) continue;
    changed[t] = true;
    ++count;
    triangles[t] = {from, between[0], third};
    for (std::size_t k = 0; k < between.size(); ++k)
      triangles.push_back({between[k], k + 1 < between.size() ? between[k + 1] : to, third});
  }
  return count;
}

} // namespace

SewnMesh sewn(const Mesh& mesh, double tolerance, Repetition dropped_kind) {
  // A triangle has three edges, and splitting one may bring two more to be split.
  constexpr int kMostRounds = 16;
  std::vector<Triangle> triangles = mesh.triangles();
  std::size_t dropped = tidy(triangles, dropped_kind), splits = 0;
  const std::size_t welded = weld(mesh.vertices(), triangles, tolerance);
  dropped += tidy(triangles, dropped_kind);
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t count = split(mesh.vertices(), triangles, tolerance);
    splits += count;
    if (count == 0) break;
  }
  if (dropped + welded + splits == 0 || triangles.empty()) return {mesh};
  return {Mesh(mesh.vertices(), triangles), dropped, welded, splits};
}

} // namespace abbe
