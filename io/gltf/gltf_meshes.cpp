// Meshes: rows of primitives, each with points, indices and a material of its own.

#include "geometry/meshes/close_mesh.h"
#include "io/gltf/gltf_state.h"
#include "io/meshes/match_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace abbe {
namespace {

using glm::dvec3;

/// How a primitive lists its corners.
enum class Mode : std::uint8_t { triangles = 4, strip = 5, fan = 6 };

std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& corners, Mode mode) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::size_t i) { return static_cast<std::int32_t>(corners[i]); };
  if (mode == Mode::triangles)
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
      triangles.push_back({at(i), at(i + 1), at(i + 2)});
  else if (mode == Mode::strip)
    for (std::size_t i = 0; i + 2 < corners.size(); ++i)
      triangles.push_back({at(i), at(i + 1 + i % 2), at(i + 2 - i % 2)});
  else
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles.push_back({at(i), at(i + 1), at(0)});
  return triangles;
}

/// The accessor of an attribute such as "POSITION".
std::optional<std::size_t> attribute(GltfState& state, const GltfValue& primitive,
                                     std::string_view name) {
  const auto attributes = primitive.find("attributes");
  return attributes ? attributes->index(name, state.document.all("accessors").size(), "accessors")
                    : std::nullopt;
}

Polygons read_points(GltfState& state, const GltfValue& primitive, std::size_t positions) {
  Polygons polygons;
  const std::vector<double> p = read_accessor(state, primitive, positions, 3);
  polygons.vertices.reserve(p.size() / 3);
  for (std::size_t i = 0; i < p.size(); i += 3)
    polygons.vertices.emplace_back(p[i], p[i + 1], p[i + 2]);
  if (const auto normals = attribute(state, primitive, "NORMAL")) {
    const std::vector<double> n = read_accessor(state, primitive, *normals, 3);
    if (n.size() != p.size())
      throw ReadError(primitive.where(), "the primitive has not as many normals as points",
                      fmt::format("{} and {}", n.size() / 3, p.size() / 3),
                      std::string(kGltfAdvice));
    polygons.normals.reserve(n.size() / 3);
    for (std::size_t i = 0; i < n.size(); i += 3)
      polygons.normals.emplace_back(n[i], n[i + 1], n[i + 2]);
  }
  return polygons;
}

std::vector<std::uint32_t> read_corners(GltfState& state, const GltfValue& primitive,
                                        std::size_t points) {
  const auto indices =
      primitive.index("indices", state.document.all("accessors").size(), "accessors");
  std::vector<std::uint32_t> corners;
  if (indices) {
    corners = read_indices(state, *indices);
    for (const std::uint32_t corner : corners)
      if (corner >= points)
        throw ReadError(primitive.where(), fmt::format("{} names no point", corner),
                        fmt::format("there are {}", points), std::string(kGltfAdvice));
    return corners;
  }
  for (std::size_t i = 0; i < points; ++i)
    corners.push_back(static_cast<std::uint32_t>(i));
  return corners;
}

/// What is told of attributes that have no effect.
void refuse_attributes(GltfState& state, const GltfValue& primitive) {
  if (primitive.find("targets"))
    refuse(state, *primitive.find("targets"), "a mesh with morph targets",
           "it is read as it rests");
  if (attribute(state, primitive, "COLOR_0"))
    refuse(state, *primitive.find("attributes")->find("COLOR_0"), "a colour of vertices",
           "a primitive has one colour");
}

/// Adds a primitive unless nothing of it would be seen.
void read_primitive(GltfState& state, const GltfValue& primitive, std::vector<GltfPart>& parts) {
  if (primitive.extension("KHR_draco_mesh_compression"))
    throw ReadError(primitive.where(), "the mesh is packed by KHR_draco_mesh_compression",
                    "it is not unpacked here",
                    "npx @gltf-transform/cli copy in.glb out.glb unpacks it");
  refuse_extensions(state, primitive, {});
  const auto material =
      primitive.index("material", state.document.all("materials").size(), "materials");
  if (is_invisible(state, material)) return;
  const std::size_t mode = primitive.whole("mode").value_or(4);
  if (mode < 4 || mode > 6)
    return refuse(state, primitive, "a primitive of points or lines", "triangles are read");
  const auto positions = attribute(state, primitive, "POSITION");
  if (!positions)
    return refuse(state, primitive, "a primitive without POSITION", "it has no shape");
  refuse_attributes(state, primitive);

  Polygons polygons = read_points(state, primitive, *positions);
  CutPolygons cut;
  cut.triangles = triangles_of(read_corners(state, primitive, polygons.vertices.size()),
                               static_cast<Mode>(mode));
  if (!polygons.normals.empty()) cut.normals = cut.triangles;
  if (cut.triangles.empty()) return;
  try {
    Mesh mesh(polygons.vertices, cut.triangles);
    if (fills_solid(state, material)) mesh = close_mesh(mesh).mesh;
    const bool solid = mesh.is_closed();
    parts.push_back({primitive.where(), with_normals(mesh, polygons, cut),
                     gltf_material(state, material, solid)});
  } catch (const std::invalid_argument& fault) {
    throw ReadError(primitive.where(), "the mesh holds no surface", fault.what(),
                    "Give triangles with an area");
  }
}

} // namespace

const std::vector<GltfPart>& gltf_mesh(GltfState& state, std::size_t index) {
  const auto known = state.meshes.find(index);
  if (known != state.meshes.end()) return known->second;
  std::vector<GltfPart> parts;
  for (const GltfValue& primitive : state.document.all("meshes")[index].list("primitives"))
    read_primitive(state, primitive, parts);
  return state.meshes.emplace(index, std::move(parts)).first->second;
}

} // namespace abbe
