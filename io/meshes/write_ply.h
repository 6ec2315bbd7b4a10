#pragma once

#include "geometry/meshes/mesh.h"

#include <filesystem>

namespace abbe {

/// Writes a mesh as binary PLY: coordinates as doubles, and the normals of its corners as floats
/// where it is shaded by them. Errors as `replace_file` has them.
void write_ply(const std::filesystem::path& file, const Mesh& mesh);

} // namespace abbe
