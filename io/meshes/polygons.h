#pragma once

#include "geometry/meshes/mesh_hierarchy.h"
#include "io/text/token.h"

#include <glm/vec3.hpp>

#include <vector>

namespace abbe {

/// What a mesh file holds: vertices, and polygons whose corners they are.
struct Polygons {
  std::vector<glm::dvec3> vertices;
  std::vector<std::int32_t> corners; ///< of all polygons, one after the other
  std::vector<std::size_t> ends;     ///< where each polygon's corners end in the list
  /// Of vertices, one each, or where `corner_normals` is not empty, of corners. Empty: none.
  std::vector<glm::vec3> normals;
  std::vector<std::int32_t> corner_normals; ///< the normals of `corners`; -1: none
};

/// Triangles, and the normals of their corners.
struct CutPolygons {
  std::vector<Triangle> triangles;
  std::vector<Triangle> normals; ///< indices into Polygons::normals, -1: none; empty without any
};

/// The polygons, cut into triangles. `file` is named in the warning of polygons that cross
/// themselves. Throws ReadError when there are more triangles than a mesh can hold.
[[nodiscard]] CutPolygons triangles_of(const Polygons& polygons, const std::filesystem::path& file,
                                       const Warn& warn);

} // namespace abbe
