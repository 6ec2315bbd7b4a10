#pragma once

#include "io/meshes/orientation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abbe {

/// Corners of a polygon that may lie in the way of a cut, in boxes within boxes, so that of many
/// corners few are looked at.
class CornerTree {
public:
  /// Takes in `corners`, which are numbers of points. The points must stay where they are.
  void build(std::span<const dvec2> points, const std::vector<std::int32_t>& corners);
  void remove(std::int32_t corner);
  /// Some corner that is in or on the triangle a b c, which runs counter-clockwise, and at none of
  /// its corners' places. Returns -1 when there is none. With `open`, corners on the triangle's
  /// edges do not count.
  [[nodiscard]] std::int32_t find(const std::array<dvec2, 3>& triangle, bool open) const;

private:
  struct Node {
    dvec2 lower, upper;
    std::int32_t live = 0; ///< how many corners have not been removed
  };
  struct Range {
    std::size_t node, first, end; ///< the node's corners in `order_`

    [[nodiscard]] std::size_t middle() const { return first + (end - first) / 2; }
    [[nodiscard]] bool is_leaf() const { return end - first <= 8; }
    [[nodiscard]] Range left() const { return {2 * node + 1, first, middle()}; }
    [[nodiscard]] Range right() const { return {2 * node + 2, middle(), end}; }
  };

  void build(const Range& range);
  [[nodiscard]] std::int32_t find(const Range& range, const std::array<dvec2, 3>& triangle,
                                  bool open) const;

  std::span<const dvec2> points_;
  std::vector<std::int32_t> order_; ///< the corners; -1 stands for one that was removed
  std::vector<std::size_t> place_;  ///< of each corner in `order_`
  std::vector<Node> nodes_;
};

} // namespace abbe
