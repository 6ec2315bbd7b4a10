#pragma once

#include "core/scene/scene.h"

#include <vector>

namespace abbe::bench {

/// The corners and triangles of a mesh that is not made yet.
struct Triangles {
  std::vector<dvec3> vertices;
  std::vector<Triangle> triangles;
};

/// A closed ball of radius 1 of exactly so many triangles, their normals outwards: 10, 100 or
/// another power of ten. Throws std::invalid_argument for any other number.
[[nodiscard]] Triangles ball_of_triangles(std::size_t count);

/// A camera five units before the origin, a light, a card behind, and glass for what is to stand
/// between them.
struct Stage {
  Scene scene;
  MaterialId glass_surface;
  MediumId glass;

  /// Adds a shape of glass.
  void add(Shape shape, const Transform& to_world);
};

[[nodiscard]] Stage empty_stage();

/// A stage with a glass mesh in its middle.
[[nodiscard]] Scene mesh_scene(Mesh mesh);

/// A stage with so many lenses, each what two balls have in common, side by side in a square.
[[nodiscard]] Scene lens_scene(std::size_t count);

} // namespace abbe::bench
