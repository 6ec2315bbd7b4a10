// A mesh of triangles in a file of its own, OBJ or PLY:
//
//   mesh bunny.ply

#include "io/meshes/read_mesh.h"

#include "io/files/regular_file.h"
#include "io/meshes/polygons.h"
#include "io/meshes/read_obj.h"
#include "io/meshes/read_ply.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <stdexcept>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// The whole file, which a token names.
std::string content_of(const Token& name, const fs::path& file) {
  try {
    return read_regular_file(file);
  } catch (const std::runtime_error& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Give a file of triangles or polygons, as OBJ or PLY");
  }
}

Mesh mesh_of(const std::string& content, const fs::path& file, bool obj, const Warn& warn) {
  const Polygons polygons = obj ? read_obj(content, file, warn) : read_ply(content, file);
  return {polygons.vertices, triangles_of(polygons, file, warn)};
}

} // namespace

Mesh read_mesh(Arguments& arguments, MeshFiles& files, const Warn& warn) {
  const Token name = arguments.name_token("the name of a file");
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  const bool obj = same_name(file.extension().string(), ".obj");
  if (!obj && !same_name(file.extension().string(), ".ply"))
    throw ReadError(name.where, fmt::format("{} is no mesh", shown(name)),
                    "its name ends neither in .obj nor in .ply",
                    "Give a file of one of these formats");
  std::error_code error;
  const fs::path key = fs::canonical(file, error);
  if (error == std::errc::no_such_file_or_directory)
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "meshes are found relative to the file that names them",
                    "Check the name, or write the whole path");
  if (const auto known = files.find(key); known != files.end()) return known->second;
  const std::string content = content_of(name, file);
  try {
    return files.emplace(key, mesh_of(content, file, obj, warn)).first->second;
  } catch (const ReadError& fault) {
    throw fault.with(fmt::format(" [mesh at {}]", to_string(name.where)));
  } catch (const std::invalid_argument& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" holds no surface", file.string()), fault.what(),
                    "Give a file with triangles or polygons");
  }
}

} // namespace abbe
