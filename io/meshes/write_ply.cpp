#include "io/meshes/write_ply.h"

#include "io/files/atomic_file.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace abbe {
namespace {

/// The bytes of a number, the lowest first, as the header says.
template <class Number>
void put(std::string& bytes, Number number) {
  static_assert(std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(Number));
}

/// The rows of vertices and of triangles.
struct Rows {
  std::string vertices, triangles;
  std::size_t vertex_count = 0;
};

void put_triangle(Rows& rows, const Triangle& corners) {
  put(rows.triangles, std::uint8_t{3});
  for (const std::int32_t corner : corners)
    put(rows.triangles, corner);
}

Rows plain_rows(const Mesh& mesh) {
  Rows rows;
  for (const dvec3& vertex : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis)
      put(rows.vertices, vertex[axis]);
  rows.vertex_count = mesh.vertices().size();
  for (const Triangle& triangle : mesh.triangles())
    put_triangle(rows, triangle);
  return rows;
}

/// One row for each vertex and normal that meet in a corner. Flat triangles have corners of their
/// own, with the triangle's normal.
Rows rows_with_normals(const Mesh& mesh, const CornerNormals& corners) {
  Rows rows;
  const auto add = [&](std::int32_t vertex, const glm::vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
      put(rows.vertices, mesh.vertices()[static_cast<std::size_t>(vertex)][axis]);
    for (int axis = 0; axis < 3; ++axis)
      put(rows.vertices, normal[axis]);
    return static_cast<std::int32_t>(rows.vertex_count++);
  };
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known;
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    Triangle triangle = mesh.triangles()[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t normal = corners.of_triangles[t][i];
      if (normal < 0) {
        triangle[i] = add(triangle[i], glm::vec3(outward_normal(mesh, {}, static_cast<int>(t))));
        continue;
      }
      const auto [place, is_new] = known.try_emplace({triangle[i], normal}, 0);
      if (is_new)
        place->second = add(triangle[i], corners.normals[static_cast<std::size_t>(normal)]);
      triangle[i] = place->second;
    }
    put_triangle(rows, triangle);
  }
  return rows;
}

} // namespace

void write_ply(const std::filesystem::path& file, const Mesh& mesh) {
  const CornerNormals* normals = mesh.corner_normals();
  const Rows rows = normals ? rows_with_normals(mesh, *normals) : plain_rows(mesh);
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  header += fmt::format("element vertex {}\nproperty double x\nproperty double y\n"
                        "property double z\n",
                        rows.vertex_count);
  if (normals) header += "property float nx\nproperty float ny\nproperty float nz\n";
  header += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                        mesh.triangles().size());
  replace_file(file, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out << header << rows.vertices << rows.triangles;
    out.close();
    if (!out) throw std::runtime_error("not all of it could be written");
  });
}

} // namespace abbe
