#pragma once

#include "geometry/meshes/edge_table.h"
#include "geometry/meshes/mesh.h"

namespace abbe {

/// A mesh whose seams have been sewn, and how much there was to do.
struct SewnMesh {
  Mesh mesh;
  std::size_t repeated = 0; ///< triangles that came twice and were dropped
  std::size_t welded = 0;   ///< vertices that were moved to another one
  std::size_t split = 0;    ///< triangles that were split, since a vertex lay on their edge
};

/// Sews a mesh together where it seems to be meant. Along its borders, which are the edges of an
/// odd number of triangles, vertices no farther apart than `tolerance` become one; and where such
/// a vertex lies on the edge of a larger triangle, at a T-junction, the triangle is split there.
/// Triangles that repeat another one in the way of `dropped` are left out.
[[nodiscard]] SewnMesh sewn(const Mesh& mesh, double tolerance, Repetition dropped);

} // namespace abbe
