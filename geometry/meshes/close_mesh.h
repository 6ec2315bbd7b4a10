#pragma once

#include "geometry/meshes/mesh.h"

namespace abbe {

/// What keeps a mesh from being a solid.
struct OpenMesh {
  std::size_t edges = 0;    ///< how many do not join triangles in pairs
  dvec3 from{0.0}, to{0.0}; ///< the ends of the first of them
  bool one_sided = false;   ///< it has one side only, as a Moebius band
};

/// A mesh that is a solid where it can be made one, and what had to be changed.
struct MendedMesh {
  Mesh mesh;                ///< the given one where it needs nothing, or cannot be closed
  OpenMesh open;            ///< says something where the mesh is not closed
  std::size_t repeated = 0; ///< triangles that came twice and were dropped
  std::size_t welded = 0;   ///< vertices that were moved, by at most `tolerance`
  std::size_t split = 0;    ///< triangles that were split at a vertex on their edge
  std::size_t turned = 0;   ///< triangles that were turned over
  double tolerance = 0.0;
};

/// Closes a mesh if welding, splitting and turning its triangles can do that; see `sewn` and
/// `orient_parts`. A mesh that bounds a solid already stays as it is.
[[nodiscard]] MendedMesh close_mesh(const Mesh& mesh);

} // namespace abbe
