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
};

/// The polygons, cut into triangles. `file` is named in the warning of polygons that cross
/// themselves. Throws ReadError when there are more triangles than a mesh can hold.
[[nodiscard]] std::vector<Triangle>
triangles_of(const Polygons& polygons, const std::filesystem::path& file, const Warn& warn);

} // namespace abbe
