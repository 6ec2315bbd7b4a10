#include "geometry/meshes/edge_table.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace abbe {

EdgeTable::EdgeTable(std::size_t vertex_count, const std::vector<Triangle>& triangles)
    : sides_(3 * triangles.size()) {
  const auto side_of = [&](std::size_t t, std::size_t i) {
    const std::int32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
    return TriangleSide{std::min(from, to), std::max(from, to), static_cast<std::int32_t>(t),
                        static_cast<std::uint8_t>(i), from < to};
  };
  // Sides are sorted by their lower vertex first, by counting, which takes a time that grows with
  // their number only; then those of one vertex, of which there are few.
  std::vector<std::size_t> place(vertex_count + 1, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      ++place[static_cast<std::size_t>(side_of(t, i).lower) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  const std::vector<std::size_t> begins = place;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleSide side = side_of(t, i);
      sides_[place[static_cast<std::size_t>(side.lower)]++] = side;
    }
  for (std::size_t v = 0; v < vertex_count; ++v)
    std::sort(sides_.begin() + static_cast<std::ptrdiff_t>(begins[v]),
              sides_.begin() + static_cast<std::ptrdiff_t>(begins[v + 1]),
              [](const TriangleSide& a, const TriangleSide& b) {
                return std::tie(a.upper, a.triangle, a.side) <
                       std::tie(b.upper, b.triangle, b.side);
              });
}

bool is_balanced(std::span<const TriangleSide> edge) {
  const auto forward =
      std::count_if(edge.begin(), edge.end(), [](const TriangleSide& s) { return s.forward; });
  return 2 * static_cast<std::size_t>(forward) == edge.size();
}

std::vector<bool> repeated(const std::vector<Triangle>& triangles, Repetition kind) {
  std::vector<bool> found(triangles.size(), false);
  if (kind == Repetition::none) return found;
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto turned = [&](std::size_t t) { // so that the lowest corner comes first
    Triangle corners = triangles[t];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if (kind == Repetition::any_sense && corners[1] > corners[2]) std::swap(corners[1], corners[2]);
    return corners;
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(turned(a), a) < std::pair(turned(b), b);
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    found[order[i]] = turned(order[i]) == turned(order[i - 1]);
  return found;
}

bool are_closed(std::size_t vertex_count, const std::vector<Triangle>& triangles) {
  bool balanced = true, simple = true;
  EdgeTable(vertex_count, triangles).for_each_edge([&](std::span<const TriangleSide> edge) {
    balanced = balanced && is_balanced(edge);
    simple = simple && edge.size() == 2;
  });
  if (!balanced || simple) return balanced;
  const std::vector<bool> again = repeated(triangles, Repetition::same_sense);
  return std::find(again.begin(), again.end(), true) == again.end();
}

} // namespace abbe
