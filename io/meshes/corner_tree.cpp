#include "io/meshes/corner_tree.h"

#include <glm/common.hpp>

#include <algorithm>

namespace abbe {
namespace {

/// True when the box surely lies outside the triangle: beyond one of its edges, or of its box.
bool is_apart(const std::array<dvec2, 3>& t, const dvec2& lower, const dvec2& upper) {
  if (std::max({t[0].x, t[1].x, t[2].x}) < lower.x || std::min({t[0].x, t[1].x, t[2].x}) > upper.x)
    return true;
  if (std::max({t[0].y, t[1].y, t[2].y}) < lower.y || std::min({t[0].y, t[1].y, t[2].y}) > upper.y)
    return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 &a = t[i], &b = t[(i + 1) % 3];
    const dvec2 leftmost(b.y >= a.y ? lower.x : upper.x, b.x >= a.x ? upper.y : lower.y);
    if (orientation(a, b, leftmost) < 0) return true;
  }
  return false;
}

bool holds(const std::array<dvec2, 3>& t, const dvec2& p, bool open) {
  if (p == t[0] || p == t[1] || p == t[2]) return false;
  const int least = open ? 1 : 0;
  return orientation(t[0], t[1], p) >= least && orientation(t[1], t[2], p) >= least &&
         orientation(t[2], t[0], p) >= least;
}

} // namespace

void CornerTree::build(std::span<const dvec2> points, const std::vector<std::int32_t>& corners) {
  points_ = points;
  order_ = corners;
  nodes_.clear();
  place_.resize(points.size());
  build(Range{0, 0, order_.size()});
  for (std::size_t i = 0; i < order_.size(); ++i)
    place_[static_cast<std::size_t>(order_[i])] = i;
}

void CornerTree::build(const Range& range) {
  if (nodes_.size() <= range.node) nodes_.resize(range.node + 1);
  if (range.first == range.end) return;
  const auto point = [&](std::int32_t corner) -> const dvec2& {
    return points_[static_cast<std::size_t>(corner)];
  };
  Node node{point(order_[range.first]), point(order_[range.first]),
            static_cast<std::int32_t>(range.end - range.first)};
  for (std::size_t i = range.first; i < range.end; ++i) {
    node.lower = glm::min(node.lower, point(order_[i]));
    node.upper = glm::max(node.upper, point(order_[i]));
  }
  nodes_[range.node] = node;
  if (range.is_leaf()) return;
  const bool wide = node.upper.x - node.lower.x >= node.upper.y - node.lower.y;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(range.first), at(range.middle()), at(range.end),
                   [&](std::int32_t a, std::int32_t b) {
                     return wide ? point(a).x < point(b).x : point(a).y < point(b).y;
                   });
  build(range.left());
  build(range.right());
}

void CornerTree::remove(std::int32_t corner) {
  const std::size_t place = place_[static_cast<std::size_t>(corner)];
  Range range{0, 0, order_.size()};
  --nodes_[range.node].live;
  while (!range.is_leaf()) {
    range = place < range.middle() ? range.left() : range.right();
    --nodes_[range.node].live;
  }
  order_[place] = -1;
}

std::int32_t CornerTree::find(const std::array<dvec2, 3>& triangle, bool open) const {
  return order_.empty() ? -1 : find(Range{0, 0, order_.size()}, triangle, open);
}

std::int32_t CornerTree::find(const Range& range, const std::array<dvec2, 3>& triangle,
                              bool open) const {
  const Node& node = nodes_[range.node];
  if (node.live == 0 || is_apart(triangle, node.lower, node.upper)) return -1;
  if (!range.is_leaf()) {
    const std::int32_t found = find(range.left(), triangle, open);
    return found >= 0 ? found : find(range.right(), triangle, open);
  }
  for (std::size_t i = range.first; i < range.end; ++i)
    if (order_[i] >= 0 && holds(triangle, points_[static_cast<std::size_t>(order_[i])], open))
      return order_[i];
  return -1;
}

} // namespace abbe
