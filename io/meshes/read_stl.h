#pragma once

#include "io/meshes/polygons.h"

#include <string_view>

namespace abbe {

/// Reads the triangles of an STL file, whose content is `bytes`, in text or in binary. Corners of
/// the same coordinates become one vertex. Normals, names and colours are left out. Throws
/// ReadError at the word, or with the number of the byte.
[[nodiscard]] Polygons read_stl(std::string_view bytes, const std::filesystem::path& file);

} // namespace abbe
