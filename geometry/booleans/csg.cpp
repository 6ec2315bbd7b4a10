#include "geometry/booleans/csg.h"

#include "geometry/booleans/bounding_ball.h"
#include "geometry/rays/short_vector.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace abbe {
namespace {

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

/// True when rounding cannot tell which of two roots comes first.
bool coincide(const Root& a, const Root& b) {
  return std::abs(a.t - b.t) <= a.t_error + b.t_error;
}

using Intervals = std::span<const Interval>;

/// A walk along an ascending interval list, from root to root.
class Walk {
public:
  explicit Walk(Intervals list) : next_(list.data()), stop_(next_ + list.size()) {}

  [[nodiscard]] bool done() const { return next_ == stop_; }
  /// The root to be passed next.
  [[nodiscard]] const Root& root() const { return inside_ ? next_->exit : next_->enter; }
  [[nodiscard]] bool inside() const { return inside_; }
  void pass() {
    next_ += inside_ ? 1 : 0;
    inside_ = !inside_;
  }

private:
  const Interval *next_, *stop_;
  bool inside_ = false;
};

/// True when nothing of the combined solid can lie beyond the ends of its operands' lists.
bool all_met(CsgOperation operation, const Walk& left, const Walk& right) {
  if (left.done()) return operation != CsgOperation::unite || right.done();
  return operation == CsgOperation::intersect && right.done();
}

/// Walks two ascending interval lists and appends their combination to `found`. Where a root of one
/// coincides with a root of the other, both are passed at once: faces that touch leave neither a
/// gap between them nor a film.
void merge(CsgOperation operation, Intervals left_list, Intervals right_list,
           ShortVector<Interval, 4>& found) {
  Walk left(left_list), right(right_list);
  bool inside = false;
  Interval open;
  while (!all_met(operation, left, right)) {
    const bool both = !left.done() && !right.done();
    const bool left_first = right.done() || (both && left.root().t <= right.root().t);
    const Root* root = left_first ? &left.root() : &right.root();
    const bool together = both && coincide(left.root(), right.root());
    if (together) {
      const Root& second = left_first ? right.root() : left.root();
      (left_first ? left : right).pass();
      if (combined(operation, left.inside(), right.inside()) == inside) root = &second;
      (left_first ? right : left).pass();
    } else {
      (left_first ? left : right).pass();
    }
    if (combined(operation, left.inside(), right.inside()) == inside) continue;
    inside = !inside;
    if (inside)
      open.enter = *root;
    else if (open.exit = *root; open.enter.t < open.exit.t)
      found.push_back(open);
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

namespace {

/// The part of the line inside a leaf.
std::optional<Interval> intersect_leaf(const CsgTree& tree, std::int32_t number,
                                       const LocalRay& ray, std::span<const CsgContact> contacts) {
  const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(number)];
  const FaceContact* face = nullptr;
  for (const CsgContact& contact : contacts)
    if (contact.leaf == number) {
      face = &contact.face;
      break;
    }
  auto found = std::visit(
      [&](const auto& solid) { return intersect(solid, local_ray(leaf.to_tree, ray), face); },
      leaf.solid);
  if (found) found->enter.face.leaf = found->exit.face.leaf = number;
  return found;
}

} // namespace

void intersect(const CsgTree& tree, const LocalRay& ray, std::span<const CsgContact> contacts,
               std::vector<Interval>& intervals) {
  // Each pending result is a run of `intervals`; `starts` remembers where the runs begin.
  ShortVector<std::size_t, 16> starts;
  for (const CsgTree::Step& step : tree.steps()) {
    if (step.leaf >= 0) {
      starts.push_back(intervals.size());
      const auto found = intersect_leaf(tree, step.leaf, ray, contacts);
      if (found) intervals.push_back(*found);
      continue;
    }
    const std::size_t middle = starts[starts.size() - 1];
    starts.erase(starts.size() - 1);
    const std::size_t begin = starts[starts.size() - 1];
    const Intervals all(intervals);
    ShortVector<Interval, 4> found;
    merge(step.operation, all.subspan(begin, middle - begin), all.subspan(middle), found);
    intervals.resize(begin);
    intervals.insert(intervals.end(), found.begin(), found.end());
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

namespace {

/// To first order.
double distance_to_face(const CsgTree& tree, const dvec3& point, FaceId face) {
  return std::abs(glm::dot(outward_normal(tree, point, face), point - snapped(tree, point, face)));
}

/// See WayOut; infinite where the ray does not leave by the face.
double move_to_leave(const CsgTree& tree, const dvec3& point, const dvec3& direction, FaceId face) {
  const double distance = distance_to_face(tree, point, face);
  if (!runs_in(outward_normal(tree, point, face), direction)) return distance;
  const CsgLeaf& leaf = tree.leaves()[static_cast<std::size_t>(face.leaf)];
  if (leaf.flipped) return kInfinity; // a hollow: the line does not come back to it
  const FaceContact contact{face.face, Side::inside};
  const LocalRay ray = local_ray(leaf.to_tree, {point, direction});
  const auto chord =
      std::visit([&](const auto& solid) { return intersect(solid, ray, &contact); }, leaf.solid);
  if (!chord || chord->exit.t == kInfinity || chord->exit.face.face != face.face) return kInfinity;
  return distance + distance_to_face(tree, point + 0.5 * chord->exit.t * direction, face);
}

} // namespace

WayOut nearest_way_out(const CsgTree& tree, const dvec3& point, const dvec3& direction) {
  WayOut nearest;
  double smallest = kInfinity;
  const auto try_face = [&](FaceId face) {
    const double move = move_to_leave(tree, point, direction, face);
    const double distance = distance_to_face(tree, point, face);
    if (std::tie(move, distance) >= std::tie(nearest.move, smallest)) return;
    nearest = {face, move};
    smallest = distance;
  };
  for (std::size_t i = 0; i < tree.leaves().size(); ++i) {
    const CsgLeaf& leaf = tree.leaves()[i];
    // The solid ends where a leaf that is taken away begins.
    const dvec3 d = leaf.to_tree.inverse_vector(leaf.flipped ? -direction : direction);
    const int face = std::visit(
        [&](const auto& solid) {
          return nearest_face(solid, leaf.to_tree.inverse_point(point), d);
        },
        leaf.solid);
    try_face({static_cast<std::int32_t>(i), face});
    // The one curved face of a ball or a cylinder, also where the ray runs in from it.
    if (face != 0 && std::holds_alternative<TaperedCylinder>(leaf.solid))
      try_face({static_cast<std::int32_t>(i), 0});
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

namespace {

/// What a part of a tree lies in: a box, and a ball where spheres make one.
struct Extent {
  Bounds box;
  std::optional<BoundingBall> ball;
};

Extent common_extent(const Extent& a, const Extent& b) {
  if (!a.ball || !b.ball) return {a.box.overlap(b.box), a.ball ? a.ball : b.ball};
  const BoundingBall ball = ball_around_common(*a.ball, *b.ball);
  const Bounds around{ball.center - ball.radius, ball.center + ball.radius};
  return {a.box.overlap(b.box).overlap(around), ball};
}

} // namespace

Bounds bounds(const CsgTree& tree, const Transform& to_world) {
  const auto of_leaf = [&](const CsgLeaf& leaf) -> Extent {
    const Transform map = to_world.after(leaf.to_tree);
    return {std::visit([&](const auto& solid) { return bounds(solid, map); }, leaf.solid),
            std::holds_alternative<Sphere>(leaf.solid) ? std::optional(image_of_unit_ball(map))
                                                       : std::nullopt};
  };
  const auto combined = [](CsgOperation operation, const Extent& left,
                           const Extent& right) -> Extent {
    switch (operation) {
    case CsgOperation::unite:
      return {left.box.joined(right.box), std::nullopt};
    case CsgOperation::intersect:
      return common_extent(left, right);
    case CsgOperation::subtract:
      break;
    }
    return left;
  };
  return evaluate(tree, of_leaf, combined).box;
}

} // namespace abbe
