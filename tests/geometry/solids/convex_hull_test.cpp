#include "geometry/solids/convex_hull.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <algorithm>
#include <stdexcept>

using namespace abbe;
using reference::Random;

namespace {

std::vector<dvec3> cube_corners() {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return corners;
}

} // namespace

TEST_CASE("hull: a cube's corners give six faces, whatever lies in or on it") {
  std::vector<dvec3> points = cube_corners();
  for (const dvec3 p : {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(1, 1, 0.5), dvec3(1, 1, 1)})
    points.push_back(p);
  const auto planes = hull_planes(points);
  REQUIRE(planes.size() == 6);
  for (const HalfSpace& h : planes) {
    CHECK(h.offset == Approx(1.0));
    CHECK(std::max({std::abs(h.normal.x), std::abs(h.normal.y), std::abs(h.normal.z)}) == 1.0);
  }
}

TEST_CASE("hull: of points on a ball every one is a vertex, and all lie under all planes") {
  Random random(90);
  for (const int count : {4, 12, 40}) {
    std::vector<dvec3> points;
    for (int i = 0; i < count; ++i)
      points.push_back(random.direction());
    // Far from the origin and stretched, as long as it has a volume.
    for (const dvec3& shift : {dvec3(0), dvec3(1e4, 0, 0)}) {
      std::vector<dvec3> moved;
      for (const dvec3& p : points)
        moved.push_back(shift + dvec3(1, 1, 20) * p);
      const auto planes = hull_planes(moved);
      CHECK(planes.size() == static_cast<std::size_t>(2 * count - 4)); // Euler: all triangles
      for (const dvec3& p : moved) {
        int on = 0;
        for (const HalfSpace& h : planes) {
          const double height = glm::dot(h.normal, p) - h.offset;
          CHECK(height < 1e-6);
          on += height > -1e-7;
        }
        CHECK(on >= 3);
      }
      CHECK(ConvexPolyhedron(planes).vertices().size() >= points.size());
    }
  }
}

TEST_CASE("hull: what has no volume is refused") {
  CHECK_THROWS_AS(hull_planes({}), std::invalid_argument);
  CHECK_THROWS_AS(hull_planes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(hull_planes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), std::invalid_argument);
}
