#include "geometry/meshes/mesh_hierarchy.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace abbe {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;

struct FloatBox {
  glm::vec3 lower{kFloatInfinity}, upper{-kFloatInfinity};

  void join(const glm::vec3& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void join(const FloatBox& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  /// Half the surface; 0 of an empty box.
  [[nodiscard]] float area() const {
    const glm::vec3 e = glm::max(upper - lower, glm::vec3(0.0f));
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }
};

/// A triangle that is being sorted into the hierarchy.
struct Item {
  FloatBox box;
  std::int32_t triangle = 0;

  [[nodiscard]] glm::vec3 centre() const { return 0.5f * (box.lower + box.upper); }
};

/// Triangles that stand together, with the box around them.
struct Part {
  std::span<Item> items;
  FloatBox box;

  explicit Part(std::span<Item> parts) : items(parts) {
    for (const Item& item : items)
      box.join(item.box);
  }
  [[nodiscard]] bool is_leaf() const { return items.size() <= MeshLeaf::kMost; }
};

glm::vec3 rounded(const dvec3& v, float towards) {
  glm::vec3 f;
  for (int i = 0; i < 3; ++i)
    f[i] = std::nextafter(static_cast<float>(v[i]), towards);
  return f;
}

/// Sorts centres along one axis into bins.
class Bins {
public:
  Bins(const FloatBox& centres, int axis) : axis_(axis), first_(centres.lower[axis]) {
    const float extent = centres.upper[axis] - centres.lower[axis];
    if (extent > kBins / std::numeric_limits<float>::max())
      per_bin_ = static_cast<float>(kBins) / extent;
  }

  [[nodiscard]] bool part() const { return per_bin_ > 0.0f; }
  [[nodiscard]] int of(const Item& item) const {
    return std::min(static_cast<int>((item.centre()[axis_] - first_) * per_bin_), kBins - 1);
  }

private:
  int axis_;
  float first_;
  float per_bin_ = 0.0f; ///< 0 where the centres are at one place
};

/// The cost of intersecting so many triangles.
float cost(int count) {
  const int leaves = (count + MeshLeaf::kMost - 1) / MeshLeaf::kMost;
  return static_cast<float>(leaves);
}

struct Split {
  float cost = kFloatInfinity;
  int axis = 0, last_bin = 0; ///< the first half ends with this bin
};

Split best_split(const Part& part, const FloatBox& centres) {
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const Bins bins(centres, axis);
    if (!bins.part()) continue;
    std::array<FloatBox, kBins> boxes;
    std::array<int, kBins> counts{};
    for (const Item& item : part.items) {
      const auto bin = static_cast<std::size_t>(bins.of(item));
      boxes[bin].join(item.box);
      ++counts[bin];
    }
    std::array<float, kBins> behind{}; // the cost of all bins behind this one
    FloatBox box;
    int count = 0;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      box.join(boxes[bin]);
      count += counts[bin];
      if (count > 0) behind[bin - 1] = box.area() * cost(count);
    }
    box = {};
    count = 0;
    for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
      box.join(boxes[bin]);
      count += counts[bin];
      if (count == 0 || count == static_cast<int>(part.items.size())) continue;
      const float whole = box.area() * cost(count) + behind[bin];
      if (whole < best.cost) best = {whole, axis, static_cast<int>(bin)};
    }
  }
  return best;
}

/// How many items the first of two halves gets, which are brought to the front.
std::size_t divide(const Part& part, bool halve) {
  FloatBox centres;
  for (const Item& item : part.items)
    centres.join(item.centre());
  const Split split = best_split(part, centres);
  const auto begin = part.items.begin();
  if (!halve && split.cost < kFloatInfinity) {
    const Bins bins(centres, split.axis);
    return static_cast<std::size_t>(
        std::partition(begin, part.items.end(),
                       [&](const Item& item) { return bins.of(item) <= split.last_bin; }) -
        begin);
  }
  const auto half = static_cast<std::ptrdiff_t>(part.items.size() / 2);
  std::nth_element(begin, begin + half, part.items.end(), [&](const Item& a, const Item& b) {
    return a.centre()[split.axis] < b.centre()[split.axis];
  });
  return static_cast<std::size_t>(half);
}

class Builder {
public:
  Builder(MeshHierarchy& hierarchy, std::span<Item> items) : hierarchy_(hierarchy), items_(items) {}

  std::int32_t build(const Part& whole, int depth) {
    std::vector<Part> parts{whole};
    while (parts.size() < 8) {
      Part* largest = nullptr;
      for (Part& part : parts)
        if (!part.is_leaf() && (!largest || part.box.area() > largest->box.area())) largest = &part;
      if (!largest) break;
      const std::span<Item> items = largest->items;
      const std::size_t first = divide(*largest, depth >= MeshHierarchy::kMostSplits);
      *largest = Part(items.first(first));
      parts.emplace_back(items.subspan(first));
    }
    const std::size_t place = hierarchy_.nodes.size();
    hierarchy_.nodes.push_back(boxes(parts));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto count = static_cast<std::int32_t>(parts[i].items.size());
      const auto first = static_cast<std::int32_t>(parts[i].items.data() - items_.data());
      hierarchy_.nodes[place].child[i] =
          parts[i].is_leaf() ? MeshLeaf{first, count}.child() : build(parts[i], depth + 1);
    }
    return static_cast<std::int32_t>(place);
  }

private:
  static MeshNode boxes(const std::vector<Part>& parts) {
    MeshNode node{};
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 8; ++i) {
        const FloatBox box = i < parts.size() ? parts[i].box : FloatBox{};
        node.lower[static_cast<std::size_t>(axis)][i] = box.lower[axis];
        node.upper[static_cast<std::size_t>(axis)][i] = box.upper[axis];
      }
    return node;
  }

  MeshHierarchy& hierarchy_;
  std::span<Item> items_;
};

} // namespace

Bounds MeshHierarchy::bounds(const MeshNode& node, std::size_t box) const {
  Bounds found;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    found.lower[axis] = centre[axis] + static_cast<double>(node.lower[a][box]);
    found.upper[axis] = centre[axis] + static_cast<double>(node.upper[a][box]);
  }
  return found;
}

MeshHierarchy make_hierarchy(const std::vector<dvec3>& vertices, std::vector<Triangle>& triangles) {
  const auto at = [&](std::int32_t corner) { return vertices[static_cast<std::size_t>(corner)]; };
  Bounds all;
  for (const Triangle& t : triangles)
    for (const std::int32_t corner : t)
      all = all.joined({at(corner), at(corner)});
  MeshHierarchy hierarchy;
  hierarchy.centre = 0.5 * (all.lower + all.upper);
  std::vector<Item> items(triangles.size());
  FloatBox whole;
  for (std::size_t i = 0; i < items.size(); ++i) {
    Bounds box;
    for (const std::int32_t corner : triangles[i]) {
      const dvec3 p = at(corner) - hierarchy.centre;
      box = box.joined({p, p});
    }
    items[i].box = {rounded(box.lower, -kFloatInfinity), rounded(box.upper, kFloatInfinity)};
    items[i].triangle = static_cast<std::int32_t>(i);
    whole.join(items[i].box);
  }
  hierarchy.radius = glm::length(dvec3(glm::max(-whole.lower, whole.upper)));
  Builder(hierarchy, items).build(Part(items), 0);
  std::vector<Triangle> sorted;
  sorted.reserve(triangles.size());
  for (const Item& item : items)
    sorted.push_back(triangles[static_cast<std::size_t>(item.triangle)]);
  triangles = std::move(sorted);
  return hierarchy;
}

} // namespace abbe
