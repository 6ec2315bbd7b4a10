#pragma once

#include "geometry/meshes/mesh.h"

#include <cstddef>
#include <vector>

namespace abbe {

/// How the triangles of a mesh must be turned for it to bound a solid.
struct PartOrientation {
  std::vector<bool> turn;     ///< triangle by triangle
  std::size_t open_edges = 0; ///< edges that stay unbalanced whatever is turned
  dvec3 open_from, open_to;   ///< the ends of the first of them
  bool one_sided = false;     ///< as a Moebius band
};

/// Finds which triangles are to be turned. Triangles that share an edge with no third one get the
/// same sense, that of most of them. Then each connected part is turned outwards, or inwards where
/// it lies inside an odd number of others and so bounds a hollow.
[[nodiscard]] PartOrientation orient_parts(const Mesh& mesh);

} // namespace abbe
