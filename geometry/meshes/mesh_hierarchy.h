#pragma once

#include "geometry/rays/transform.h"

#include <array>
#include <cstdint>
#include <vector>

namespace abbe {

/// The corners of a triangle: indices into a mesh's vertices, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// Boxes around eight parts of a mesh at most, in single precision and rounded outwards, relative
/// to the hierarchy's centre. Axis first, so that one instruction takes one side of all eight.
struct alignas(32) MeshNode {
  using Side = std::array<float, 8>;
  std::array<Side, 3> lower, upper; ///< no box: lower above upper
  /// Where a box's content is: the number of another node, or as MeshLeaf says.
  std::array<std::int32_t, 8> child;

  [[nodiscard]] bool holds(std::size_t box) const { return lower[0][box] <= upper[0][box]; }
};

/// Triangles `first` to first + count - 1; in MeshNode::child a negative number stands for them.
struct MeshLeaf {
  static constexpr std::int32_t kMost = 4; ///< as many as are intersected at once
  std::int32_t first = 0, count = 0;

  [[nodiscard]] static bool is(std::int32_t child) { return child < 0; }
  [[nodiscard]] static MeshLeaf of(std::int32_t child) {
    return {~child / kMost, ~child % kMost + 1};
  }
  [[nodiscard]] std::int32_t child() const { return ~(first * kMost + count - 1); }
};

/// Boxes within boxes around the triangles of a mesh. Node 0 is the root.
struct MeshHierarchy {
  /// The most nodes from the root to a leaf: splits by the SAH come first, then halves.
  static constexpr int kMostSplits = 32, kDeepest = kMostSplits + 32;

  dvec3 centre{0.0};
  double radius = 0.0; ///< of a ball about the centre that holds all boxes
  std::vector<MeshNode> nodes;

  /// Box `box` of a node, in the mesh's frame.
  [[nodiscard]] Bounds bounds(const MeshNode& node, std::size_t box) const;
};

/// Builds the hierarchy and brings the triangles into the order of its leaves. Splits where the
/// surface area heuristic [Wal07] finds the least cost among 16 bins per axis.
[[nodiscard]] MeshHierarchy make_hierarchy(const std::vector<dvec3>& vertices,
                                           std::vector<Triangle>& triangles);

} // namespace abbe
