#include "geometry/csg.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

LocalRay leaf_ray(const CsgLeaf& leaf, const LocalRay& ray) {
  const Ray local = leaf.to_tree.inverse_ray({ray.origin, ray.direction});
  return {local.origin, local.direction,
          leaf.to_tree.inverse_error(ray.origin, ray.coordinate_error)};
}

/// Whether the combined solid holds a stretch of the line that is inside or outside its operands.
bool combined(CsgOperation operation, bool in_left, bool in_right) {
  switch (operation) {
  case CsgOperation::unite:
    return in_left || in_right;
  case CsgOperation::intersect:
    return in_left && in_right;
  case CsgOperation::subtract:
    return in_left && !in_right;
  }
  return false;
}

/// Walks two ascending interval lists, [begin, middle) and [middle, end) of `lists`, from one root
/// to the next and appends their combination after `end`.
void merge(CsgOperation operation, std::vector<Interval>& lists, std::size_t begin,
           std::size_t middle, std::size_t end) {
  std::size_t left = begin, right = middle;
  bool in_left = false, in_right = false, inside = false;
  Interval open;
  while (left < end || right < end) {
    const auto next = [&](std::size_t i, std::size_t stop, bool in) {
      return i >= stop ? kInfinity : in ? lists[i].exit.t : lists[i].enter.t;
    };
    const bool left_done = left >= middle, right_done = right >= end;
    if (left_done && right_done) break;
    const bool take_left =
        right_done || (!left_done && next(left, middle, in_left) <= next(right, end, in_right));
    std::size_t& i = take_left ? left : right;
    bool& in = take_left ? in_left : in_right;
    const Root root = in ? lists[i].exit : lists[i].enter;
    if (in) ++i;
    in = !in;
    const bool now = combined(operation, in_left, in_right);
    if (now && !inside) open.enter = root;
    if (!now && inside) {
      open.exit = root;
      if (open.enter.t < open.exit.t) lists.push_back(open);
    }
    inside = now;
  }
}

/// Postfix evaluation of one number per leaf.
template <class Leaf, class Combine>
auto evaluate(const CsgTree& tree, const Leaf& leaf_value, const Combine& combine) {
  std::vector<decltype(leaf_value(tree.leaves()[0]))> stack;
  for (const CsgTree::Step& step : tree.steps()) {
    if (step.leaf >= 0) {
      stack.push_back(leaf_value(tree.leaves()[static_cast<std::size_t>(step.leaf)]));
      continue;
    }
    const auto right = stack.back();
    stack.pop_back();
    stack.back() = combine(step.operation, stack.back(), right);
  }
  return stack.back();
}

} // namespace

CsgTree::CsgTree(Convex solid, const Transform& to_tree, MaterialId material)
    : leaves_{{std::move(solid), to_tree, material, false}}, steps_{{0, {}}} {}

CsgTree::CsgTree(CsgOperation operation, CsgTree left, CsgTree right)
    : leaves_(std::move(left.leaves_)), steps_(std::move(left.steps_)) {
  const auto shift = static_cast<std::int32_t>(leaves_.size());
  for (CsgLeaf& leaf : right.leaves_) {
    if (operation == CsgOperation::subtract) leaf.flipped = !leaf.flipped;
    leaves_.push_back(std::move(leaf));
  }
  for (Step step : right.steps_) {
    if (step.leaf >= 0) step.leaf += shift;
    steps_.push_back(step);
  }
  steps_.push_back({-1, operation});
}

CsgTree CsgTree::moved(const Transform& outer) const {
  CsgTree tree = *this;
  for (CsgLeaf& leaf : tree.leaves_)
    leaf.to_tree = outer.after(leaf.to_tree);
  return tree;
}

void intersect(const CsgTree& tree, const LocalRay& ray, const CsgContact* contact,
               std::vector<Interval>& intervals) {
  // Each pending result is a run of `intervals`; `starts` remembers where the runs begin.
  thread_local std::vector<std::size_t> starts;
  starts.clear();
  for (const CsgTree::Step& step : tree.steps()) {
    if (step.leaf >= 0) {
      const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(step.leaf)];
      const FaceContact* face = contact && contact->leaf == step.leaf ? &contact->face : nullptr;
      starts.push_back(intervals.size());
      auto found =
          std::visit([&](const auto& solid) { return intersect(solid, leaf_ray(leaf, ray), face); },
                     leaf.solid);
      if (found) {
        found->enter.face.leaf = found->exit.face.leaf = step.leaf;
        intervals.push_back(*found);
      }
      continue;
    }
    const std::size_t middle = starts.back();
    starts.pop_back();
    const std::size_t begin = starts.back(), end = intervals.size();
    merge(step.operation, intervals, begin, middle, end);
    const auto first = intervals.begin();
    intervals.erase(first + static_cast<std::ptrdiff_t>(begin),
                    first + static_cast<std::ptrdiff_t>(end));
  }
}

dvec3 outward_normal(const CsgTree& tree, const dvec3& point, FaceId face) {
  const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(face.leaf)];
  const dvec3 n = std::visit(
      [&](const auto& solid) {
        return outward_normal(solid, leaf.to_tree.inverse_point(point), face.face);
      },
      leaf.solid);
  return (leaf.flipped ? -1.0 : 1.0) * leaf.to_tree.normal(n);
}

dvec3 snapped(const CsgTree& tree, const dvec3& point, FaceId face) {
  const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(face.leaf)];
  return std::visit(
      [&](const auto& solid) {
        return leaf.to_tree.point(snapped(solid, leaf.to_tree.inverse_point(point), face.face));
      },
      leaf.solid);
}

FaceId nearest_face(const CsgTree& tree, const dvec3& point) {
  FaceId nearest;
  double smallest = kInfinity;
  for (std::size_t i = 0; i < tree.leaves().size(); ++i) {
    const CsgLeaf& leaf = tree.leaves()[i];
    std::visit(
        [&](const auto& solid) {
          const dvec3 p = leaf.to_tree.inverse_point(point);
          const double distance = std::abs(signed_distance(solid, p));
          if (distance >= smallest) return;
          smallest = distance;
          nearest = {static_cast<std::int32_t>(i), nearest_face(solid, p)};
        },
        leaf.solid);
  }
  return nearest;
}

double signed_distance(const CsgTree& tree, const dvec3& point) {
  return evaluate(
      tree,
      [&](const CsgLeaf& leaf) {
        return std::visit(
            [&](const auto& solid) {
              return signed_distance(solid, leaf.to_tree.inverse_point(point));
            },
            leaf.solid);
      },
      [](CsgOperation operation, double left, double right) {
        switch (operation) {
        case CsgOperation::unite:
          return std::min(left, right);
        case CsgOperation::intersect:
          return std::max(left, right);
        case CsgOperation::subtract:
          return std::max(left, -right);
        }
        return left;
      });
}

Bounds bounds(const CsgTree& tree, const Transform& to_world) {
  return evaluate(
      tree,
      [&](const CsgLeaf& leaf) {
        return std::visit(
            [&](const auto& solid) { return bounds(solid, to_world.after(leaf.to_tree)); },
            leaf.solid);
      },
      [](CsgOperation operation, const Bounds& left, const Bounds& right) {
        switch (operation) {
        case CsgOperation::unite:
          return left.joined(right);
        case CsgOperation::intersect:
          return left.overlap(right);
        case CsgOperation::subtract:
          return left;
        }
        return left;
      });
}

} // namespace abbe
