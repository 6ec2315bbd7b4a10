#include "geometry/rays/transform.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

using namespace abbe;
using reference::Random;

namespace {

double distance(const dvec3& a, const dvec3& b) {
  return glm::length(a - b);
}

} // namespace

TEST_CASE("a transform and its inverse undo each other") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Transform t(random.linear(), random.in_cube(10.0));
    const dvec3 p = random.in_cube(10.0);
    REQUIRE(distance(t.inverse_point(t.point(p)), p) < 1e-13);
    REQUIRE(distance(t.inverse().point(t.point(p)), p) < 1e-13);
    REQUIRE(distance(t.inverse_vector(t.vector(p)), p) < 1e-13);
  }
}

TEST_CASE("after composes from right to left") {
  const Transform turn = Transform::rotation(90, {0, 0, 1});
  const Transform shift = Transform::translation({1, 0, 0});
  REQUIRE(turn.after(shift).point({0, 0, 0}) == dvec3(0, 1, 0));
  REQUIRE(shift.after(turn).point({1, 0, 0}) == dvec3(1, 1, 0));
}

TEST_CASE("rotations are right-handed and exact at quarter turns") {
  REQUIRE(Transform::rotation(90, {0, 0, 3}).point({1, 2, 3}) == dvec3(-2, 1, 3));
  REQUIRE(Transform::rotation(180, {0, 1, 0}).point({1, 2, 3}) == dvec3(-1, 2, -3));
  REQUIRE(Transform::rotation(-90, {1, 0, 0}).point({1, 2, 3}) == dvec3(1, 3, -2));
  // About (1,1,1) a third of a turn sends x to y.
  REQUIRE(distance(Transform::rotation(120, {1, 1, 1}).point({1, 0, 0}), {0, 1, 0}) < 1e-15);
}

TEST_CASE("normals stay normal to the surface, also under a mirror") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Transform t(random.linear(), random.in_cube(10.0));
    const dvec3 n = random.direction();
    const dvec3 tangent = glm::cross(n, random.direction());
    const dvec3 mapped = t.normal(n);
    REQUIRE(std::abs(glm::length(mapped) - 1.0) < 1e-15);
    REQUIRE(std::abs(glm::dot(mapped, t.vector(tangent))) < 1e-13);
    REQUIRE(glm::dot(mapped, t.vector(n)) > 0.0); // still on the outer side
  }
}

TEST_CASE("maps that flatten space are refused") {
  REQUIRE_THROWS_AS(Transform::scaling({1, 0, 1}), std::invalid_argument);
  REQUIRE_THROWS_AS(Transform::rotation(10, {0, 0, 0}), std::invalid_argument);
  REQUIRE_NOTHROW(Transform::scaling({1e-4, 1e-4, 1e-4}));
}

TEST_CASE("inverse_error bounds the rounding of a point mapped into the world and back") {
  Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    glm::dmat3 linear = random.linear();
    linear[random.below(3)] *= std::exp(random.uniform(-9, 9));
    const dvec3 offset = random.in_cube(std::exp(random.uniform(-3, 12)));
    const Transform t(linear, offset);
    const dvec3 local = random.in_cube(1.0);
    const dvec3 world = t.point(local);
    const dvec3 off = t.inverse_point(world) - local;
    const double error = std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)});
    worst = std::max(worst, error / t.inverse_error(world, 0.0));
  }
  CHECK(worst < 1.0);
}

TEST_CASE("inverse_error: where long terms cancel in the map into the world") {
  // A point on the short axes of a stretched shape: its coordinates are sums of long terms.
  Random random(5);
  double worst = 0.0;
  for (int i = 0; i < 20000; ++i) {
    glm::dmat3 stretch(1.0);
    stretch[0][0] = 1000.0;
    const glm::dmat3 inner = random.rotation();
    const Transform t(random.rotation() * stretch * inner, dvec3(0.0));
    const dvec3 local = glm::transpose(inner) * dvec3(0, random.uniform(-1, 1), 0.5);
    const dvec3 world = t.point(local), off = t.inverse_point(world) - local;
    const double error = std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)});
    worst = std::max(worst, error / t.inverse_error(world, 0.0));
  }
  CHECK(worst < 1.0);
}

TEST_CASE("boxes hold what they must and no more") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const glm::dmat3 linear = random.linear();
    const Transform t(linear, random.in_cube(10.0));
    const Bounds cube = t.box({dvec3(-1.0), dvec3(1.0)}), ball = t.unit_sphere_box();
    Bounds corners;
    for (int k = 0; k < 8; ++k) {
      const dvec3 p = t.point({k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1});
      corners = corners.joined({p, p});
    }
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(cube.lower[axis] == Approx(corners.lower[axis]).margin(1e-13));
      REQUIRE(cube.upper[axis] == Approx(corners.upper[axis]).margin(1e-13));
      // Of the ball's points p, row . p is largest where p is along the row.
      const dvec3 row(linear[0][axis], linear[1][axis], linear[2][axis]);
      REQUIRE(ball.upper[axis] == Approx(t.point(glm::normalize(row))[axis]).margin(1e-13));
      REQUIRE(ball.lower[axis] == Approx(t.point(-glm::normalize(row))[axis]).margin(1e-13));
    }
  }
}

TEST_CASE("bounds are empty when any axis is") {
  REQUIRE(Bounds{}.empty());
  const Bounds a{{0, 0, 0}, {1, 1, 1}};
  REQUIRE_FALSE(a.empty());
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 shift(0.0);
    shift[axis] = 2.0;
    const Bounds apart = a.overlap({a.lower + shift, a.upper + shift});
    CHECK(apart.empty());
    CHECK(apart.largest_coordinate() == 0.0);
  }
  REQUIRE(Bounds{{-3, 0, 0}, {1, 2, 1}}.largest_coordinate() == 3.0);
}
