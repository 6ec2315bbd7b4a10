#pragma once

#include "geometry/meshes/close_mesh.h"
#include "io/text/read_arguments.h"

#include <filesystem>
#include <map>

namespace abbe {

/// The meshes of the files that have been read, by canonical path.
using MeshFiles = std::map<std::filesystem::path, MendedMesh>;

/// Reads the triangles of an OBJ or PLY file, which is found from the folder of the file that names
/// it. Polygons are cut into triangles; normals, colours and materials are left out. A mesh that is
/// not closed is mended where that closes it, with a warning of what has been changed. A
/// file is read once: the mesh shares its triangles with those that came from the file before.
/// Throws ReadError at the name, or at the place in the file, which then tells the name's too.
[[nodiscard]] const MendedMesh& read_mesh(Arguments& arguments, MeshFiles& files, const Warn& warn);

/// The error of a transparent material on a mesh that is not closed.
[[nodiscard]] ReadError open_mesh_error(const SourcePosition& where, const OpenMesh& open);

} // namespace abbe
