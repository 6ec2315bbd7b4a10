#pragma once

#include "geometry/meshes/mesh.h"
#include "io/meshes/polygons.h"

namespace abbe {

/// The mesh, shaded by the normals that its file gives to the corners of triangles. The mesh's own
/// order of triangles and corners does not matter; triangles that mending has made, and those whose
/// normals are their own, remain flat.
[[nodiscard]] Mesh with_normals(const Mesh& mesh, const Polygons& polygons, const CutPolygons& cut);

} // namespace abbe
