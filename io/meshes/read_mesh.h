#pragma once

#include "geometry/meshes/close_mesh.h"
#include "io/text/read_arguments.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace abbe {

/// The meshes of the files that have been read, by canonical path.
using MeshFiles = std::map<std::filesystem::path, MendedMesh>;

enum class MeshFormat : std::uint8_t { obj, ply, stl };

/// What the extension of the name tells, whatever its case, and before a .gz behind it; nothing
/// where no reader knows it.
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& file);

/// The content of a mesh file, unpacked where its name ends in .gz. Throws std::runtime_error with
/// the reason alone.
[[nodiscard]] std::string mesh_bytes(const std::filesystem::path& file);

/// The mesh of a file whose content is `bytes`; otherwise as below. Throws ReadError, and
/// std::invalid_argument where there is no surface.
[[nodiscard]] MendedMesh mesh_of(std::string_view bytes, const std::filesystem::path& file,
                                 MeshFormat format, const Warn& warn);

/// Reads the triangles of an OBJ, PLY or STL file, which is found from the folder of the file that
/// names it. Polygons are cut into triangles; normals shade it smoothly; colours and materials are
/// left out. A mesh that is not closed is mended where that closes it, with a warning of what has
/// been changed. A file is read once: the mesh shares its triangles with those that came from the
/// file before. Throws ReadError at the name, or at the place in the file, which then tells the
/// name's too.
[[nodiscard]] const MendedMesh& read_mesh(Arguments& arguments, MeshFiles& files, const Warn& warn);

/// The error of a transparent material on a mesh that is not closed.
[[nodiscard]] ReadError open_mesh_error(const SourcePosition& where, const OpenMesh& open);

} // namespace abbe
