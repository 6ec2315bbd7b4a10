#pragma once

#include "geometry/mesh.h"
#include "io/read_arguments.h"

namespace abbe {

/// Reads the triangles of an OBJ or PLY file, which is found from the folder of the file that names
/// it. Polygons are cut into triangles; normals, colours and materials are left out. Throws
/// ReadError at the name.
[[nodiscard]] Mesh read_mesh(Arguments& arguments);

} // namespace abbe
