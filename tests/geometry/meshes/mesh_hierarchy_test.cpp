#include "geometry/meshes/mesh_hierarchy.h"

#include "geometry/meshes/mesh.h"
#include "tests/catch.h"
#include "tests/geometry/mesh_reference.h"
#include "tests/geometry/random.h"

#include <algorithm>

using namespace abbe;
using namespace abbe::reference;

namespace {

/// What a walk over all nodes finds.
struct Found {
  std::vector<int> times; ///< that a triangle stands in a leaf
  int depth = 0, outside = 0;
};

void visit(const MeshHierarchy& hierarchy, const std::vector<dvec3>& vertices,
           const std::vector<Triangle>& triangles, std::int32_t node, std::vector<Bounds> around,
           Found& found) {
  found.depth = std::max(found.depth, static_cast<int>(around.size()) + 1);
  const MeshNode& here = hierarchy.nodes[static_cast<std::size_t>(node)];
  for (std::size_t i = 0; i < 8; ++i) {
    if (!here.holds(i)) continue;
    around.push_back(hierarchy.bounds(here, i));
    if (MeshLeaf::is(here.child[i])) {
      const MeshLeaf leaf = MeshLeaf::of(here.child[i]);
      CHECK(leaf.count >= 1);
      CHECK(leaf.count <= MeshLeaf::kMost);
      CHECK(MeshLeaf{leaf.first, leaf.count}.child() == here.child[i]);
      for (int t = leaf.first; t < leaf.first + leaf.count; ++t) {
        ++found.times[static_cast<std::size_t>(t)];
        for (const std::int32_t corner : triangles[static_cast<std::size_t>(t)])
          for (const Bounds& box : around) {
            const dvec3& p = vertices[static_cast<std::size_t>(corner)];
            for (int axis = 0; axis < 3; ++axis)
              if (p[axis] < box.lower[axis] || p[axis] > box.upper[axis]) ++found.outside;
          }
      }
    } else {
      visit(hierarchy, vertices, triangles, here.child[i], around, found);
    }
    around.pop_back();
  }
}

void check(const std::vector<dvec3>& vertices, std::vector<Triangle> triangles) {
  const std::vector<Triangle> before = triangles;
  const MeshHierarchy hierarchy = make_hierarchy(vertices, triangles);
  CHECK(std::is_permutation(before.begin(), before.end(), triangles.begin(), triangles.end()));
  Found found{std::vector<int>(triangles.size()), 0, 0};
  visit(hierarchy, vertices, triangles, 0, {}, found);
  CHECK(found.outside == 0);
  CHECK(std::count(found.times.begin(), found.times.end(), 1) ==
        static_cast<std::ptrdiff_t>(triangles.size()));
  CHECK(found.depth <= MeshHierarchy::kDeepest);
  for (const Triangle& t : triangles)
    for (const std::int32_t corner : t)
      CHECK(glm::length(vertices[static_cast<std::size_t>(corner)] - hierarchy.centre) <=
            hierarchy.radius);
}

} // namespace

TEST_CASE("mesh hierarchy: each triangle stands in one leaf, within all boxes above it") {
  for (const Mesh& mesh : {icosphere(0), icosphere(3), torus(3, 3), torus(60, 20)})
    check(mesh.vertices(), mesh.triangles());
}

TEST_CASE("mesh hierarchy: triangles at random, and far from the origin") {
  Random random(320);
  for (const double away : {0.0, 1e6}) {
    std::vector<dvec3> vertices;
    std::vector<Triangle> triangles;
    for (std::int32_t i = 0; i < 1000; ++i) {
      const dvec3 p = away * random.direction() + random.in_cube(1.0);
      for (int c = 0; c < 3; ++c)
        vertices.push_back(p + random.in_cube(random.chance(0.1) ? 1.0 : 0.01));
      triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    check(vertices, triangles);
  }
}

TEST_CASE("mesh hierarchy: no path from the root is long where splits part little") {
  // All about one centre; and each half as far out as the one before, so that every bin but the
  // last holds next to nothing.
  std::vector<dvec3> rings, spiral;
  std::vector<Triangle> triangles;
  for (std::int32_t i = 0; i < 400; ++i) {
    for (const dvec3& p : {dvec3(1, 0, -1), dvec3(-1, 1, 0), dvec3(0, -1, 1)}) {
      rings.push_back(p * (1.0 + 0.01 * i));
      spiral.push_back((dvec3(3, 3, 3) + p) * std::ldexp(1.0, i % 120 - 60));
    }
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  check(rings, triangles);
  check(spiral, triangles);
}
