#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace abbe::stress {

/// A closed mesh whose triangles turn counter-clockwise, seen from outside.
struct Triangles {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
};

/// The meshes that random scenes name: `ball` is convex, `star` is hollow between its points,
/// `ring` has a hole, `wedge` is a thin tetrahedron. Empty for any other name.
[[nodiscard]] Triangles named_mesh(std::string_view name);

/// Writes them as `name.obj`.
void write_meshes(const std::string& folder);

} // namespace abbe::stress
