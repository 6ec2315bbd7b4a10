// A mesh of triangles in a file of its own, OBJ, PLY or STL:
//
//   mesh bunny.ply

#include "io/meshes/read_mesh.h"

#include "io/files/gunzip.h"
#include "io/files/regular_file.h"
#include "io/meshes/match_normals.h"
#include "io/meshes/polygons.h"
#include "io/meshes/read_obj.h"
#include "io/meshes/read_ply.h"
#include "io/meshes/read_stl.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

bool is_packed(const fs::path& file) {
  return same_name(file.extension().string(), ".gz");
}

/// The whole file, which a token names.
std::string content_of(const Token& name, const fs::path& file) {
  try {
    return mesh_bytes(file);
  } catch (const std::runtime_error& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Give a file of triangles or polygons, as OBJ, PLY or STL");
  }
}

std::string counted(std::size_t count, std::string_view one, std::string_view several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// What has been done to close a mesh; empty: nothing.
std::string changes(const MendedMesh& mended) {
  std::string list;
  const auto add = [&](const std::string& change) { list += (list.empty() ? "" : ", ") + change; };
  if (mended.repeated > 0)
    add(counted(mended.repeated, "triangle that came twice was dropped",
                "triangles that came twice were dropped"));
  if (mended.welded > 0)
    add(counted(mended.welded, "vertex was moved", "vertices were moved") +
        fmt::format(" by at most {:.2g}", mended.tolerance));
  if (mended.split > 0)
    add(counted(mended.split, "triangle was split at a vertex on its edge",
                "triangles were split at vertices on their edges"));
  if (mended.turned > 0)
    add(counted(mended.turned, "triangle was turned over", "triangles were turned over"));
  return list;
}

Polygons polygons_of(std::string_view bytes, const fs::path& file, MeshFormat format,
                     const Warn& warn) {
  switch (format) {
  case MeshFormat::obj:
    return read_obj(bytes, file, warn);
  case MeshFormat::ply:
    return read_ply(bytes, file);
  case MeshFormat::stl:
    return read_stl(bytes, file);
  }
  return {};
}

} // namespace

std::optional<MeshFormat> mesh_format(const fs::path& file) {
  const std::string extension = (is_packed(file) ? file.stem() : file).extension().string();
  for (const auto& [known, format] :
       {std::pair(".obj", MeshFormat::obj), {".ply", MeshFormat::ply}, {".stl", MeshFormat::stl}})
    if (same_name(extension, known)) return format;
  return std::nullopt;
}

std::string mesh_bytes(const fs::path& file) {
  std::string bytes = read_regular_file(file);
  return is_packed(file) ? gunzip(bytes) : bytes;
}

MendedMesh mesh_of(std::string_view bytes, const fs::path& file, MeshFormat format,
                   const Warn& warn) {
  const Polygons polygons = polygons_of(bytes, file, format, warn);
  const CutPolygons cut = triangles_of(polygons, file, warn);
  MendedMesh mended = close_mesh({polygons.vertices, cut.triangles});
  mended.mesh = with_normals(mended.mesh, polygons, cut);
  if (const std::string list = changes(mended); !list.empty())
    warn(fmt::format("{}: the mesh has been mended, so that it bounds a solid: {}", file.string(),
                     list));
  return mended;
}

const MendedMesh& read_mesh(Arguments& arguments, MeshFiles& files, const Warn& warn) {
  const Token name = arguments.name_token("the name of a file");
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  const std::optional<MeshFormat> format = mesh_format(file);
  if (!format)
    throw ReadError(name.where, fmt::format("{} is no mesh", shown(name)),
                    "its name ends neither in .obj nor in .ply nor in .stl",
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
    return files.emplace(key, mesh_of(content, file, *format, warn)).first->second;
  } catch (const ReadError& fault) {
    throw fault.with(fmt::format(" [mesh at {}]", to_string(name.where)));
  } catch (const std::invalid_argument& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" holds no surface", file.string()), fault.what(),
                    "Give a file with triangles or polygons");
  }
}

ReadError open_mesh_error(const SourcePosition& where, const OpenMesh& open) {
  const auto place = [](const glm::dvec3& p) {
    return fmt::format("({:g} {:g} {:g})", p.x, p.y, p.z);
  };
  const std::string why =
      open.one_sided ? "it has one side only, as a Moebius band"
                     : fmt::format("{}; {} from {} to {}",
                                   counted(open.edges, "edge does not join triangles in pairs",
                                           "edges do not join triangles in pairs"),
                                   open.edges == 1 ? "it goes" : "the first goes", place(open.from),
                                   place(open.to));
  return {
      where, "the mesh is not closed, so that nothing can fill it", why,
      "Close it where it was made (fill its holes, merge its vertices, remove walls inside it), "
      "or give thinGlass for a sheet"};
}

} // namespace abbe
