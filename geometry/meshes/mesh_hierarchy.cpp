#include "geometry/meshes/mesh_hierarchy.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace abbe {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;
/// Fewer items than this are not worth a task of their own.
constexpr std::size_t kGrain = 8192;

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

/// What `add` finds in the items, in parallel where they are many. The result must not depend on
/// the order in which pieces are added up by `join`.
template <class Found, class Add, class Join>
Found found_in(std::span<const Item> items, const Add& add, const Join& join) {
  if (items.size() <= kGrain) {
    Found found;
    for (const Item& item : items)
      add(found, item);
    return found;
  }
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, items.size(), kGrain), Found{},
      [&](const tbb::blocked_range<std::size_t>& range, Found found) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          add(found, items[i]);
        return found;
      },
      join);
}

/// The boxes around the items, and around their centres.
struct Extents {
  FloatBox box, centres;
};
Extents extents_of(std::span<const Item> items) {
  return found_in<Extents>(
      items,
      [](Extents& found, const Item& item) {
        found.box.join(item.box);
        found.centres.join(item.centre());
      },
      [](Extents a, const Extents& b) {
        a.box.join(b.box);
        a.centres.join(b.centres);
        return a;
      });
}

/// Triangles that stand together, with the boxes around them and around their centres.
struct Part {
  std::span<Item> items;
  FloatBox box, centres;

  explicit Part(std::span<Item> parts) : items(parts) {
    const Extents extents = extents_of(items);
    box = extents.box;
    centres = extents.centres;
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

/// What the bins of each axis hold.
struct BinContents {
  std::array<std::array<FloatBox, kBins>, 3> boxes;
  std::array<std::array<int, kBins>, 3> counts{};
};

BinContents contents_of(std::span<const Item> items, const std::array<Bins, 3>& bins) {
  return found_in<BinContents>(
      items,
      [&](BinContents& found, const Item& item) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (!bins[axis].part()) continue;
          const auto bin = static_cast<std::size_t>(bins[axis].of(item));
          found.boxes[axis][bin].join(item.box);
          ++found.counts[axis][bin];
        }
      },
      [](BinContents a, const BinContents& b) {
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (std::size_t bin = 0; bin < kBins; ++bin) {
            a.boxes[axis][bin].join(b.boxes[axis][bin]);
            a.counts[axis][bin] += b.counts[axis][bin];
          }
        return a;
      });
}

Split best_split(const Part& part) {
  const std::array<Bins, 3> bins{Bins(part.centres, 0), Bins(part.centres, 1),
                                 Bins(part.centres, 2)};
  const BinContents contents = contents_of(part.items, bins);
  Split best;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!bins[a].part()) continue;
    const auto& boxes = contents.boxes[a];
    const auto& counts = contents.counts[a];
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
  const Split split = best_split(part);
  const auto begin = part.items.begin();
  if (!halve && split.cost < kFloatInfinity) {
    const Bins bins(part.centres, split.axis);
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

/// Builds the nodes of a part of the items. Nodes come before their content, which comes in the
/// order of the boxes, so that the result does not depend on what is built at the same time.
class Builder {
public:
  explicit Builder(std::span<Item> items) : items_(items) {}

  /// The nodes of `whole`, whose numbers count from 0.
  [[nodiscard]] std::vector<MeshNode> build(const Part& whole, int depth) const {
    std::vector<MeshNode> nodes;
    add(nodes, whole, depth);
    return nodes;
  }

private:
  /// Adds the nodes of a part, and returns the number of the first.
  std::int32_t add(std::vector<MeshNode>& nodes, const Part& whole, int depth) const {
    const std::vector<Part> parts = divided(whole, depth);
    const std::size_t place = nodes.size();
    nodes.push_back(boxes(parts));
    if (whole.items.size() > kGrain) return add_apart(nodes, place, parts, depth);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::int32_t child =
          parts[i].is_leaf() ? leaf(parts[i]) : add(nodes, parts[i], depth + 1);
      nodes[place].child[i] = child;
    }
    return static_cast<std::int32_t>(place);
  }

  /// Builds the content of a node in tasks, and puts it behind the node.
  std::int32_t add_apart(std::vector<MeshNode>& nodes, std::size_t place,
                         const std::vector<Part>& parts, int depth) const {
    std::array<std::vector<MeshNode>, 8> contents;
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      if (!parts[i].is_leaf()) contents[i] = build(parts[i], depth + 1);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto first = static_cast<std::int32_t>(nodes.size());
      nodes[place].child[i] = parts[i].is_leaf() ? leaf(parts[i]) : first;
      for (MeshNode& node : contents[i]) {
        for (std::int32_t& child : node.child) // empty boxes have the number 0 and no content
          if (!MeshLeaf::is(child) && child > 0) child += first;
        nodes.push_back(node);
      }
      contents[i] = {};
    }
    return static_cast<std::int32_t>(place);
  }

  /// Up to eight parts, of which the one with the largest surface is divided next.
  static std::vector<Part> divided(const Part& whole, int depth) {
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
    return parts;
  }

  [[nodiscard]] std::int32_t leaf(const Part& part) const {
    const auto count = static_cast<std::int32_t>(part.items.size());
    return MeshLeaf{static_cast<std::int32_t>(part.items.data() - items_.data()), count}.child();
  }

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
  using Range = tbb::blocked_range<std::size_t>;
  const Range all_triangles(0, triangles.size(), kGrain);
  const Bounds all = tbb::parallel_reduce(
      all_triangles, Bounds{},
      [&](const Range& range, Bounds found) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          for (const std::int32_t corner : triangles[i])
            found = found.joined({at(corner), at(corner)});
        return found;
      },
      [](const Bounds& a, const Bounds& b) { return a.joined(b); });
  MeshHierarchy hierarchy;
  hierarchy.centre = 0.5 * (all.lower + all.upper);
  std::vector<Item> items(triangles.size());
  tbb::parallel_for(all_triangles, [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      Bounds box;
      for (const std::int32_t corner : triangles[i]) {
        const dvec3 p = at(corner) - hierarchy.centre;
        box = box.joined({p, p});
      }
      items[i].box = {rounded(box.lower, -kFloatInfinity), rounded(box.upper, kFloatInfinity)};
      items[i].triangle = static_cast<std::int32_t>(i);
    }
  });
  const Part whole(items);
  hierarchy.radius = glm::length(dvec3(glm::max(-whole.box.lower, whole.box.upper)));
  hierarchy.nodes = Builder(items).build(whole, 0);
  std::vector<Triangle> sorted(triangles.size());
  tbb::parallel_for(all_triangles, [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      sorted[i] = triangles[static_cast<std::size_t>(items[i].triangle)];
  });
  triangles = std::move(sorted);
  return hierarchy;
}

} // namespace abbe
