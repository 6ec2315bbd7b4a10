// A mesh of triangles in a file of its own, OBJ or PLY:
//
//   mesh bunny.ply
//
// The formats are Assimp's affair.

#include "io/meshes/read_mesh.h"

#include "spectral/data_table.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <stdexcept>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// All triangles of all parts of the file, in one list.
Mesh collected(const aiScene& scene) {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;
  for (unsigned part = 0; part < scene.mNumMeshes; ++part) {
    const aiMesh& mesh = *scene.mMeshes[part];
    const auto first = static_cast<unsigned>(vertices.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
      vertices.emplace_back(mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue; // points and lines
      Triangle triangle{};
      for (unsigned corner = 0; corner < 3; ++corner)
        triangle[corner] = static_cast<std::int32_t>(first + face.mIndices[corner]);
      triangles.push_back(triangle);
    }
  }
  return {vertices, triangles};
}

} // namespace

Mesh read_mesh(Arguments& arguments, MeshFiles& files) {
  const Token name = arguments.name_token("the name of a file");
  const fs::path file = fs::path(name.where.file).parent_path() / name.text;
  if (const std::string kind = file.extension().string();
      !same_name(kind, ".obj") && !same_name(kind, ".ply"))
    throw ReadError(name.where, fmt::format("{} is no mesh", shown(name)),
                    "its name ends neither in .obj nor in .ply",
                    "Give a file of one of these formats");
  std::error_code error;
  const fs::path key = fs::canonical(file, error);
  if (error || !fs::is_regular_file(key, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "meshes are found relative to the file that names them",
                    "Check the name, or write the whole path");
  if (const auto known = files.find(key); known != files.end()) return known->second;
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene)
    throw ReadError(name.where, fmt::format("\"{}\" cannot be understood", file.string()),
                    importer.GetErrorString(), "Write the mesh again, as OBJ or PLY");
  try {
    return files.emplace(key, collected(*scene)).first->second;
  } catch (const std::invalid_argument& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" holds no surface", file.string()), fault.what(),
                    "Give a file with triangles or polygons");
  }
}

} // namespace abbe
