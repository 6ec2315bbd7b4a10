#include "geometry/meshes/overlap.h"

#include "geometry/meshes/close_mesh.h"
#include "tests/catch.h"

#include <array>
#include <vector>

using namespace abbe;

namespace {

/// Adds a box whose triangles look outwards, or inwards where it is a hollow.
void add_box(std::vector<dvec3>& vertices, std::vector<Triangle>& triangles, const dvec3& lower,
             const dvec3& upper, bool hollow = false) {
  const auto first = static_cast<std::int32_t>(vertices.size());
  for (int i = 0; i < 8; ++i)
    vertices.emplace_back((i & 1 ? upper : lower).x, (i & 2 ? upper : lower).y,
                          (i & 4 ? upper : lower).z);
  for (const auto& [a, b, c, d] : std::vector<std::array<std::int32_t, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    const std::int32_t e = first + a, f = first + b, g = first + c, h = first + d;
    if (hollow)
      triangles.insert(triangles.end(), {{e, g, f}, {e, h, g}});
    else
      triangles.insert(triangles.end(), {{e, f, g}, {e, g, h}});
  }
}

/// Two boxes, the first of which reaches from -1 to 1.
Mesh boxes(const dvec3& lower, const dvec3& upper, bool hollow = false) {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;
  add_box(vertices, triangles, dvec3(-1), dvec3(1));
  add_box(vertices, triangles, lower, upper, hollow);
  return {vertices, triangles};
}

} // namespace

TEST_CASE("bodies of a mesh that overlap are found, at a place that lies in both") {
  // The second box goes through the first, or lies inside it as a body of its own.
  for (const auto& [lower, upper] :
       {std::pair{dvec3(-3, -0.5, -0.4), dvec3(3, 0.5, 0.6)}, std::pair{dvec3(-0.5), dvec3(0.5)},
        std::pair{dvec3(0.1, 0.1, 0.1), dvec3(5, 0.7, 0.7)}}) {
    const auto place = find_overlap(boxes(lower, upper));
    REQUIRE(place);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK((*place)[axis] >= std::max(-1.0, lower[axis]));
      CHECK((*place)[axis] <= std::min(1.0, upper[axis]));
    }
  }
}

TEST_CASE("bodies that touch or lie apart, and hollows, do not overlap") {
  CHECK_FALSE(find_overlap(boxes(dvec3(1, -1, -1), dvec3(2, 1, 1))));       // a whole face
  CHECK_FALSE(find_overlap(boxes(dvec3(1, -0.3, -0.4), dvec3(2, 0.5, 3)))); // a part of one
  CHECK_FALSE(find_overlap(boxes(dvec3(1, 1, -1), dvec3(2, 2, 1))));        // an edge
  CHECK_FALSE(find_overlap(boxes(dvec3(1), dvec3(2))));                     // a corner
  CHECK_FALSE(find_overlap(boxes(dvec3(3), dvec3(4))));
  CHECK_FALSE(find_overlap(boxes(dvec3(-0.5), dvec3(0.5), true)));
  // A body inside another whose triangles look outwards is a hollow, and is turned so.
  CHECK_FALSE(find_overlap(close_mesh(boxes(dvec3(-0.5), dvec3(0.5))).mesh));
}
