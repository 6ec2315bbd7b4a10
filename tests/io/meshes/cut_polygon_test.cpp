#include "io/meshes/cut_polygon.h"

#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace abbe;

namespace {

using glm::dvec3;
__extension__ typedef __int128 Wide;

/// A corner on a grid, in which areas are whole numbers.
struct Place {
  std::int64_t x, y;
  bool operator==(const Place&) const = default;
};
using Outline = std::vector<Place>;

Wide twice_area(const Place& a, const Place& b, const Place& c) {
  return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
}

Wide twice_area(const Outline& outline) {
  Wide sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place &p = outline[i], &q = outline[(i + 1) % outline.size()];
    sum += static_cast<Wide>(p.x) * q.y - static_cast<Wide>(p.y) * q.x;
  }
  return sum;
}

/// The outline in the plane that another axis is the normal of, not quite parallel to it.
std::vector<dvec3> placed(const Outline& outline, int axis) {
  std::vector<dvec3> vertices;
  for (const Place& p : outline) {
    dvec3 v(0.0);
    v[(axis + 1) % 3] = static_cast<double>(p.x);
    v[(axis + 2) % 3] = static_cast<double>(p.y);
    v[axis] = static_cast<double>(p.x) / 4 - static_cast<double>(p.y) / 8;
    vertices.push_back(v);
  }
  return vertices;
}

struct Cut {
  bool simple;
  std::vector<Triangle> triangles;
};

Cut cut(const Outline& outline, int axis) {
  std::vector<std::int32_t> polygon(outline.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  PolygonCutter cutter;
  Cut result{};
  result.simple = cutter.cut(placed(outline, axis), polygon, result.triangles);
  return result;
}

/// Triangles of one sense whose areas add up to the polygon's, and whose edges are the polygon's or
/// come in pairs, fill it, each place once: there are n - 2 where no corner is left out.
void check_fills(const Outline& outline, const Cut& result) {
  const Wide area = twice_area(outline);
  Wide sum = 0;
  std::map<std::pair<int, int>, int> edges; // how often each comes, less its opposite
  bool one_sense = true;
  for (const Triangle& t : result.triangles) {
    const auto at = [&](std::size_t i) { return outline[static_cast<std::size_t>(t[i])]; };
    const Wide part = twice_area(at(0), at(1), at(2));
    one_sense = one_sense && (area > 0 ? part > 0 : part < 0);
    sum += part;
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = t[i], to = t[(i + 1) % 3];
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  const int n = static_cast<int>(outline.size());
  for (int i = 0; i < n; ++i) {
    const int from = i, to = (i + 1) % n;
    edges[{std::min(from, to), std::max(from, to)}] -= from < to ? 1 : -1;
  }
  CHECK(result.simple);
  CHECK(one_sense);
  CHECK(sum == area);
  CHECK(result.triangles.size() == outline.size() - 2);
  CHECK(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; }));
}

/// With each corner first, in both senses, in three planes.
void check_all_ways(Outline outline) {
  for (int sense = 0; sense < 2; ++sense) {
    for (std::size_t first = 0; first < outline.size(); ++first) {
      for (int axis = 0; axis < 3; ++axis)
        check_fills(outline, cut(outline, axis));
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
    std::reverse(outline.begin(), outline.end());
  }
}

Outline comb(int teeth) {
  Outline outline{{0, -1}, {2 * teeth, -1}};
  for (std::int64_t i = teeth; i-- > 0;) {
    outline.push_back({2 * i + 2, 100});
    outline.push_back({2 * i + 1, 100});
    outline.push_back({2 * i + 1, 0});
    if (i > 0) outline.push_back({2 * i, 0});
  }
  outline.push_back({0, 0});
  return outline;
}

/// Corners around the origin, in the order of their angles: no edge crosses another.
Outline star(std::mt19937_64& random, int corners) {
  std::uniform_int_distribution<std::int64_t> coordinate(-1000, 1000);
  Outline outline;
  while (static_cast<int>(outline.size()) < corners) {
    const Place p{coordinate(random), coordinate(random)};
    const auto same_way = [&](const Place& q) {
      return p.x * q.y == p.y * q.x && p.x * q.x + p.y * q.y >= 0;
    };
    if (std::ranges::none_of(outline, same_way) && (p.x != 0 || p.y != 0)) outline.push_back(p);
  }
  const auto angle = [](const Place& p) {
    return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
  };
  std::ranges::sort(outline, {}, angle);
  return outline;
}

/// True when the origin is inside: no gap of half a turn or more between two corners.
bool surrounds_origin(const Outline& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place &p = outline[i], &q = outline[(i + 1) % outline.size()];
    if (p.x * q.y - p.y * q.x <= 0) return false;
  }
  return true;
}

} // namespace

TEST_CASE("concave polygons are cut into triangles that fill them, whichever corner is first") {
  check_all_ways({{0, 0}, {4, 0}, {1, 1}, {0, 4}});                                 // an arrow head
  check_all_ways({{0, 0}, {10, 0}, {10, 1}, {9, 1}});                               // convex
  check_all_ways({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});                 // an L
  check_all_ways({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}); // a U
  check_all_ways({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}); // corners on a line
  check_all_ways({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}, {0, 2}, {0, 1}}); // a triangle
  check_all_ways(comb(5));
}

TEST_CASE("one concave quad after another") {
  std::mt19937_64 random(2);
  for (int found = 0; found < 500;) {
    const Outline outline = star(random, 4);
    if (!surrounds_origin(outline)) continue;
    ++found;
    check_all_ways(outline);
  }
}

TEST_CASE("polygons of many corners") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 60; ++i) {
    const Outline outline = star(random, 5 + 3 * i);
    if (!surrounds_origin(outline)) continue;
    check_fills(outline, cut(outline, i % 3));
  }
}

TEST_CASE("a hole that is joined to the outline by two equal edges stays a hole") {
  // A square of 10 with a square hole of 2, the way to it from the corner (0, 0).
  check_all_ways(
      {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {4, 4}, {4, 6}, {6, 6}, {6, 4}, {4, 4}});
  // Two holes, both joined to the same corner.
  check_all_ways({{0, 0},
                  {20, 0},
                  {20, 20},
                  {0, 20},
                  {0, 0},
                  {4, 8},
                  {4, 10},
                  {6, 10},
                  {6, 8},
                  {4, 8},
                  {0, 0},
                  {8, 4},
                  {8, 6},
                  {10, 6},
                  {10, 4},
                  {8, 4}});
}

TEST_CASE("a corner twice in a row and a needle without area take no area away") {
  const Outline twice{{0, 0}, {2, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Outline needle{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {5, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const Outline& outline : {twice, needle}) {
    const Cut result = cut(outline, 2);
    CHECK(result.simple);
    Wide sum = 0;
    for (const Triangle& t : result.triangles) {
      const auto at = [&](std::size_t i) { return outline[static_cast<std::size_t>(t[i])]; };
      const Wide part = twice_area(at(0), at(1), at(2));
      CHECK(part > 0);
      sum += part;
    }
    CHECK(sum == 6);
  }
}

TEST_CASE("a polygon that crosses itself is cut somehow, and told") {
  CHECK_FALSE(cut({{0, 0}, {4, 4}, {4, 0}, {0, 3}}, 2).simple);
  CHECK_FALSE(cut({{0, 3}, {4, -3}, {-4, -3}, {4, 2}, {-5, 1}}, 2).simple); // a pentagram
  std::mt19937_64 random(4);
  std::uniform_int_distribution<std::int64_t> coordinate(0, 6);
  for (int i = 0; i < 3000; ++i) { // whatever there is, it ends
    Outline outline;
    for (int k = 0; k < 3 + i % 30; ++k)
      outline.push_back({coordinate(random), coordinate(random)});
    CHECK(cut(outline, i % 3).triangles.size() <= outline.size() - 2);
  }
  CHECK(cut({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, 2).simple); // nothing there to be cut
}

TEST_CASE("hundreds of thousands of corners are cut in less than quadratic time") {
  const Outline outline = comb(100000); // 400 000 corners: 10^11 pairs
  const Cut result = cut(outline, 2);
  CHECK(result.simple);
  CHECK(result.triangles.size() == outline.size() - 2);
  Wide sum = 0;
  for (const Triangle& t : result.triangles) {
    const auto at = [&](std::size_t i) { return outline[static_cast<std::size_t>(t[i])]; };
    sum += twice_area(at(0), at(1), at(2));
  }
  CHECK(sum == twice_area(outline));
}
