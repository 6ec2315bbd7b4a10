#pragma once

#include "io/meshes/polygons.h"

#include <string_view>

namespace abbe {

/// Reads the vertices, faces and strips of triangles of a PLY file, whose content is `bytes`, in
/// each of the three formats. All other elements and properties are left out. Throws ReadError at
/// the word, or with the number of the byte.
[[nodiscard]] Polygons read_ply(std::string_view bytes, const std::filesystem::path& file);

} // namespace abbe
