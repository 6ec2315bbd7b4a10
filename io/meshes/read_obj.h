#pragma once

#include "io/meshes/polygons.h"

#include <string_view>

namespace abbe {

/// Reads the vertices and faces of an OBJ file, whose content is `text`. Normals, texture
/// coordinates, colours, groups and materials are left out, and no other file is opened.
/// Statements that OBJ does not have, and surfaces in free form, are left out with a warning.
/// Throws ReadError at the word.
[[nodiscard]] Polygons read_obj(std::string_view text, const std::filesystem::path& file,
                                const Warn& warn);

} // namespace abbe
