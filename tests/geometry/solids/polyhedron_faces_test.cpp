#include "geometry/solids/convex_hull.h"
#include "geometry/solids/polyhedron_faces.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

using namespace abbe;

namespace {

/// Sum of the triangles between a corner and the edges of the polygon, as a vector along the
/// normal.
dvec3 area_of(const std::vector<dvec3>& corners) {
  dvec3 sum(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += 0.5 * glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return sum;
}

void check_area(const ConvexPolyhedron& solid, int face, double expected) {
  const dvec3 area = area_of(face_corners(solid, face));
  const dvec3 normal = solid.half_spaces()[static_cast<std::size_t>(face)].normal;
  CHECK(glm::dot(area, normal) == Approx(expected));
  CHECK(glm::length(area) == Approx(expected));
}

} // namespace

TEST_CASE("the faces of the thesis's prism") {
  // An equilateral triangle with inradius 1 has sides of 2 sqrt(3); the prism is 2 high.
  const ConvexPolyhedron prism = thesis_prism();
  for (const int end : {0, 1}) {
    CHECK(face_corners(prism, end).size() == 3);
    check_area(prism, end, 3.0 * std::sqrt(3.0));
  }
  for (const int side : {2, 3, 4}) {
    CHECK(face_corners(prism, side).size() == 4);
    check_area(prism, side, 4.0 * std::sqrt(3.0));
  }
}

TEST_CASE("faces far from the origin, and the surface they close") {
  // A tetrahedron with edges of 2 sqrt(2).
  const dvec3 away{50.0, -20.0, 7.0};
  std::vector<dvec3> corners;
  for (const dvec3 c : {dvec3(1, 1, 1), dvec3(1, -1, -1), dvec3(-1, 1, -1), dvec3(-1, -1, 1)})
    corners.push_back(c + away);
  const ConvexPolyhedron solid(hull_planes(corners));
  for (int face = 0; face < 4; ++face) {
    CHECK(face_corners(solid, face).size() == 3);
    check_area(solid, face, 2.0 * std::sqrt(3.0));
  }
}

TEST_CASE("half-spaces that bound nothing have no corners, and equal ones count once") {
  std::vector<HalfSpace> planes = thesis_prism().half_spaces();
  planes.push_back({{0, 1, 0}, 1.5}); // above the top
  planes.push_back({{0, 1, 0}, 1.0}); // the top again
  const ConvexPolyhedron solid(planes);
  CHECK(face_corners(solid, 5).empty());
  CHECK(face_corners(solid, 6).empty());
  check_area(solid, 0, 3.0 * std::sqrt(3.0));
}
