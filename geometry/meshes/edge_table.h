#pragma once

#include "geometry/meshes/mesh_hierarchy.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abbe {

/// One side of a triangle: side i runs from corner i to the next.
struct TriangleSide {
  std::int32_t lower, upper; ///< the vertices at its ends, by number
  std::int32_t triangle;
  std::uint8_t side;
  bool forward; ///< it runs from the lower vertex to the upper one
};

/// The sides of all triangles, edge by edge: sides between the same two vertices lie together.
class EdgeTable {
public:
  EdgeTable(std::size_t vertex_count, const std::vector<Triangle>& triangles);

  /// Calls `visit` with the sides of each edge, in the order of the vertices' numbers.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].lower == sides_[begin].lower &&
             sides_[end].upper == sides_[begin].upper)
        ++end;
      visit(std::span<const TriangleSide>(&sides_[begin], end - begin));
    }
  }

private:
  std::vector<TriangleSide> sides_;
};

/// True when as many triangles run along the edge in one sense as in the other.
[[nodiscard]] bool is_balanced(std::span<const TriangleSide> edge);

/// Which triangles count as repeating another one: none, those with the same corners in the same
/// sense, or those with the same corners.
enum class Repetition : std::uint8_t { none, same_sense, any_sense };

/// The triangles that repeat an earlier one.
[[nodiscard]] std::vector<bool> repeated(const std::vector<Triangle>& triangles, Repetition kind);

/// True when the triangles bound a solid: each edge is balanced, and no triangle comes twice.
[[nodiscard]] bool are_closed(std::size_t vertex_count, const std::vector<Triangle>& triangles);

} // namespace abbe
