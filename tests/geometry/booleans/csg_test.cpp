#include "geometry/booleans/csg.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <algorithm>
#include <cmath>

using namespace abbe;
constexpr auto unite = CsgOperation::unite, common = CsgOperation::intersect,
               subtract = CsgOperation::subtract;
using reference::Random;
using reference::Vec;

namespace {

std::vector<Interval> line(const CsgTree& tree, const dvec3& origin, const dvec3& direction,
                           const CsgContact* contact = nullptr) {
  std::vector<Interval> found;
  const std::span<const CsgContact> contacts(contact, contact ? 1u : 0u);
  intersect(tree, {origin, direction}, contacts, found);
  return found;
}

CsgTree ball(const dvec3& centre, double radius = 1.0) {
  return {Sphere{}, Transform::translation(centre).after(Transform::scaling(dvec3(radius)))};
}

CsgTree brick(const dvec3& lower, const dvec3& upper) {
  return {Box{}, Transform::translation(0.5 * (lower + upper))
                     .after(Transform::scaling(0.5 * (upper - lower)))};
}

bool within(const std::vector<Interval>& intervals, double t) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& i) { return i.enter.t < t && t < i.exit.t; });
}

} // namespace

TEST_CASE("csg: the three operations along an axis") {
  const CsgTree a = ball({0, 0, 0}), b = ball({0, 0, 1});
  const auto both = line({unite, a, b}, {0, 0, -3}, {0, 0, 1});
  REQUIRE(both.size() == 1);
  REQUIRE(both[0].enter.t == 2.0);
  REQUIRE(both[0].exit.t == 5.0);
  REQUIRE(both[0].exit.face.leaf == 1);
  const auto both_hold = line({common, a, b}, {0, 0, -3}, {0, 0, 1});
  REQUIRE(both_hold.size() == 1);
  REQUIRE(both_hold[0].enter.t == 3.0);
  REQUIRE(both_hold[0].enter.face.leaf == 1);
  REQUIRE(both_hold[0].exit.t == 4.0);
  REQUIRE(both_hold[0].exit.face.leaf == 0);
  const auto rest = line({subtract, a, b}, {0, 0, -3}, {0, 0, 1});
  REQUIRE(rest.size() == 1);
  REQUIRE(rest[0].enter.t == 2.0);
  REQUIRE(rest[0].exit.t == 3.0);
  REQUIRE(rest[0].exit.face.leaf == 1);
}

TEST_CASE("csg: a line that only touches meets nothing") {
  REQUIRE(line({unite, ball({0, 0, 0}), ball({0, 0, 5})}, {1, 0, -3}, {0, 0, 1}).empty());
  REQUIRE(line({subtract, ball({0, 0, 0}), ball({0, 0, 2})}, {1, 0, -3}, {0, 0, 1}).empty());
}

TEST_CASE("csg: a hollow ball has two parts, and its inner normal points inwards") {
  const CsgTree shell(subtract, ball({0, 0, 0}), ball({0, 0, 0}, 0.5));
  const auto parts = line(shell, {0, 0, -3}, {0, 0, 1});
  REQUIRE(parts.size() == 2);
  REQUIRE(parts[0].exit.t == 2.5);
  REQUIRE(parts[1].enter.t == 3.5);
  REQUIRE(outward_normal(shell, {0, 0, -0.5}, {1, 0}) == dvec3(0, 0, 1));
  REQUIRE(outward_normal(shell, {0, 0, -1}, {0, 0}) == dvec3(0, 0, -1));
  REQUIRE(signed_distance(shell, {0, 0, 0.75}) < 0.0);
  REQUIRE(signed_distance(shell, {0, 0, 0.25}) > 0.0);
}

TEST_CASE("csg: moved takes every leaf along") {
  const CsgTree tree(subtract, ball({0, 0, 0}), ball({0, 0, 1}));
  const auto parts = line(tree.moved(Transform::translation({0, 0, 10})), {0, 0, 0}, {0, 0, 1});
  REQUIRE(parts.size() == 1);
  REQUIRE(parts[0].enter.t == 9.0);
  REQUIRE(parts[0].exit.t == 10.0);
}

TEST_CASE("csg: coinciding faces leave no gap and no film, in any frame") {
  Random random(9);
  int checked = 0;
  for (int k = 0; k < 300; ++k) {
    // Frames in which the shared face z = 0 is computed differently from either side.
    const Transform frame(random.linear() * std::exp(random.uniform(-9, 9)),
                          random.in_cube(random.chance(0.5) ? 1.0 : 1e4));
    const CsgTree below = brick({-1, -1, -0.7}, {1, 1, 0}).moved(frame);
    const CsgTree above = brick({-1, -1, 0}, {1, 1, 1.3}).moved(frame);
    const CsgTree around = brick({-2, -2, -0.7}, {2, 2, 1.3}).moved(frame);
    const CsgTree inner = brick({-1, -1, -0.7}, {1, 1, 0.5}).moved(frame);
    for (int ray = 0; ray < 50; ++ray) {
      const dvec3 from = frame.point({random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), -3});
      const dvec3 to = frame.point({random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 3});
      for (const dvec3& o : {from, to}) {
        const dvec3 d = glm::normalize(to + from - o - o);
        REQUIRE(line({unite, below, above}, o, d).size() == 1);
        REQUIRE(line({common, below, above}, o, d).empty());
        REQUIRE(line({subtract, below, above}, o, d).size() == 1);
        REQUIRE(line({subtract, below, around}, o, d).empty()); // they share z = -0.7
        REQUIRE(line({subtract, around, inner}, o, d).size() <= 3);
        for (const Interval& i : line({subtract, around, inner}, o, d))
          REQUIRE(i.exit.t - i.enter.t > 2 * (i.exit.t_error + i.enter.t_error));
        ++checked;
      }
    }
  }
  REQUIRE(checked == 30000);
}

TEST_CASE("csg: points between crossings are members where the tree says so") {
  Random random(10);
  int undecided = 0, inside = 0;
  for (int k = 0; k < 400; ++k) {
    const reference::Piece piece =
        k % 4 == 0 ? reference::lens_piece(0.4) : reference::nested_piece(random);
    for (int ray = 0; ray < 50; ++ray) {
      const dvec3 o = random.in_cube(4.0);
      const dvec3 d = glm::normalize(random.in_cube(1.0) - o) * random.uniform(0.5, 2.0);
      const auto parts = line(piece.tree, o, d);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        REQUIRE(parts[i].enter.t < parts[i].exit.t);
        if (i > 0) REQUIRE(parts[i - 1].exit.t < parts[i].enter.t);
      }
      int wrong = 0;
      for (int sample = 0; sample < 40; ++sample) {
        const double t = random.uniform(-8.0, 8.0);
        const Vec p = Vec(o) + static_cast<long double>(t) * Vec(d);
        const bool member = piece.solid.contains(p);
        inside += member;
        if (member == within(parts, t)) continue;
        if (piece.solid.clearance(p) < 1e-12L)
          ++undecided;
        else
          ++wrong;
      }
      REQUIRE(wrong == 0);
    }
  }
  CHECK(inside > 10000);
  CHECK(undecided < 10);
}

TEST_CASE("csg: bounds hold every member") {
  Random random(11);
  for (int k = 0; k < 200; ++k) {
    const reference::Piece piece = reference::nested_piece(random);
    const Transform to_world(random.linear(), random.in_cube(3.0));
    const Bounds box = bounds(piece.tree, to_world);
    for (int sample = 0; sample < 200; ++sample) {
      const dvec3 p = random.in_cube(3.0);
      if (!piece.solid.contains(Vec(p))) continue;
      const dvec3 q = to_world.point(p);
      for (int axis = 0; axis < 3; ++axis) {
        REQUIRE(q[axis] >= box.lower[axis] - 1e-12);
        REQUIRE(q[axis] <= box.upper[axis] + 1e-12);
      }
    }
  }
  // Solids that lie apart have nothing in common.
  REQUIRE(bounds(CsgTree(common, ball({0, 0, 0}), ball({0, 5, 0})), Transform()).empty());
}

// Two balls of radius r, their centres d apart, meet in a circle of radius sqrt(r^2 - d^2 / 4).
TEST_CASE("csg: a lens of two balls is as wide as the circle in which they meet") {
  const CsgTree lens(common, ball({0, 0, -0.9}), ball({0, 0, 0.9}));
  const Bounds box = bounds(lens, Transform());
  const double rim = std::sqrt(1.0 - 0.81);
  CHECK(box.upper.x == Approx(rim));
  CHECK(box.lower.y == Approx(-rim));
  CHECK(box.upper.z == Approx(0.1));
  // A small ball deep inside a large one is all there is.
  const CsgTree moon(common, ball({0, 0, 0}), ball({0, 0, 0}, 0.3));
  CHECK(bounds(moon, Transform()).upper.x == Approx(0.3));
}
