#include "geometry/solids/tapered_cylinder.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

using namespace abbe;
using reference::Random;

namespace {

constexpr TaperedCylinder kCylinder{1.0}, kCone{0.0}, kFunnel{2.0};

std::optional<Interval> line(const TaperedCylinder& solid, const dvec3& origin,
                             const dvec3& direction) {
  return intersect(solid, LocalRay{origin, direction});
}

} // namespace

TEST_CASE("tapered cylinder: along the axis, and parallel to it") {
  for (const double top : {0.0, 0.5, 1.0, 2.0}) {
    const auto axis = line({top}, {0, 0, -1}, {0, 0, 1});
    REQUIRE(axis);
    CHECK(axis->enter.t == 1.0);
    CHECK(axis->enter.face.face == 1);
    CHECK(axis->exit.t == Approx(2.0));
  }
  CHECK(line(kCylinder, {0.5, 0.5, 3}, {0, 0, -2})->enter.t == 1.0);
  CHECK(line(kCylinder, {0.5, 0.5, 3}, {0, 0, -2})->enter.face.face == 2);
  CHECK_FALSE(line(kCylinder, {1.5, 0, 3}, {0, 0, -1}));
  const auto cone = line(kCone, {0.25, 0, -1}, {0, 0, 1});
  REQUIRE(cone);
  CHECK(cone->exit.t == Approx(1.75)); // radius 0.25 at z = 0.75
  CHECK(cone->exit.face.face == 0);
  CHECK(line(kFunnel, {1.5, 0, -1}, {0, 0, 1})->enter.t == Approx(1.5));
}

TEST_CASE("tapered cylinder: across, from inside, from behind, past it") {
  const auto across = line(kCylinder, {-3, 0, 0.5}, {1, 0, 0});
  REQUIRE(across);
  CHECK(across->enter.t == 2.0);
  CHECK(across->exit.t == 4.0);
  CHECK(line(kCone, {0, 0, 0.5}, {1, 0, 0})->exit.t == 0.5);
  CHECK(line(kCone, {3, 0, 0.5}, {1, 0, 0})->exit.t == -2.5);
  CHECK_FALSE(line(kCylinder, {-3, 2, 0.5}, {1, 0, 0}));
  CHECK_FALSE(line(kCylinder, {-3, 0, 1.5}, {1, 0, 0}));
  CHECK(line(kCylinder, {-3, 0, 1.0}, {1, 0, 0})); // in the plane of a cap
}

TEST_CASE("tapered cylinder: the nappe beyond the apex is no part of it") {
  CHECK_FALSE(line(kCone, {-3, 0, 1.5}, {1, 0, 0}));
  // Through the apex z = -1 of a funnel, and up into it: only what is between the caps counts.
  const auto up = line(kFunnel, {0, 0, -3}, {0, 0, 1});
  REQUIRE(up);
  CHECK(up->enter.t == 3.0);
  CHECK(up->exit.t == 4.0);
  CHECK_FALSE(line(kFunnel, {-3, 0, -1.5}, {1, 0, 0}));
}

TEST_CASE("tapered cylinder: along a line of the cone, tangent to a cylinder, at the tip") {
  // x + z = 1 - 1/8 runs inside the cone, parallel to its line x + z = 1.
  const auto inside = line(kCone, {1.875, 0, -1}, {-1, 0, 1});
  REQUIRE(inside);
  CHECK(inside->enter.t == Approx(1.0));   // at z = 0
  CHECK(inside->exit.t == Approx(1.9375)); // -x + z = 1 at z = 15/16
  const auto tangent = line(kCylinder, {1, -3, 0.5}, {0, 1, 0});
  REQUIRE(tangent);
  CHECK(tangent->enter.t == 3.0);
  CHECK(tangent->exit.t == 3.0);
  CHECK_FALSE(line(kCylinder, {1 + 1e-15, -3, 0.5}, {0, 1, 0}));
  const auto tip = line(kCone, {-3, 0, 1.0}, {1, 0, 0});
  if (tip) CHECK(tip->exit.t - tip->enter.t < 1e-7);
}

TEST_CASE("tapered cylinder: nearly along a line of the cone, the near root is as sure as any") {
  // The line down through (3/4, 0, 5/8) is turned by `turn` from the direction of the side's line
  // from (0, 0, 1) to (-1, 0, 0). It comes in by the side's other line, x + z = 1, nearly at a
  // right angle, so that the root there is as sure as coordinates are. The other root is far away.
  for (const double turn : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const dvec3 d = glm::normalize(dvec3(-1.0, 0.0, -1.0 + turn));
    const auto found = line(kCone, dvec3(0.75, 0.0, 0.625) - 2.0 * d, d);
    REQUIRE(found);
    // x + z = 1 is met at 2 + (1 - 0.75 - 0.625) / (d.x + d.z).
    const double enter = 2.0 + (1.0 - 0.75 - 0.625) / (d.x + d.z);
    CAPTURE(turn);
    CHECK(std::abs(found->enter.t - enter) <= found->enter.t_error);
    CHECK(found->enter.t_error < 1e-13);
  }
}

TEST_CASE("tapered cylinder: on the surface, with a contact") {
  Random random(7);
  for (int k = 0; k < 20000; ++k) {
    const TaperedCylinder solid{random.chance(0.3) ? 1.0 : random.uniform(0.0, 2.0)};
    // From a face to a point inside: the exit is beyond it, and never at a negative t.
    const int face = random.below(3);
    const dvec3 side = glm::normalize(random.direction() * dvec3(1, 1, 0));
    const double z = face == 0 ? random.uniform(0, 1) : face - 1.0;
    const double radius = 1.0 + solid.slope() * z;
    const dvec3 p = side * radius * (face == 0 ? 1.0 : random.uniform(0, 1)) + dvec3(0, 0, z);
    const dvec3 within = 0.9 * random.direction() * dvec3(1, 1, 0);
    const double height = random.uniform(0.01, 0.99);
    const dvec3 to = within * (1.0 + solid.slope() * height) + dvec3(0, 0, height);
    const FaceContact in{face, Side::inside}, out{face, Side::outside};
    const auto through = intersect(solid, LocalRay{p, to - p}, &in);
    REQUIRE(through);
    CHECK(through->enter.t == 0.0);
    CHECK(through->exit.t > 1.0);
    CHECK(std::abs(signed_distance(solid, p + through->exit.t * (to - p))) < 1e-10);
    CHECK_FALSE(intersect(solid, LocalRay{p, p - to}, &out));
    if (face == 0) CHECK(intersect(solid, LocalRay{p, p - to}, &in)->exit.t == 0.0);
  }
}

TEST_CASE("tapered cylinder: normal, snapping, distance, bounds") {
  CHECK(outward_normal(kCylinder, {0, 1, 0.5}, 0) == dvec3(0, 1, 0));
  CHECK(glm::length(outward_normal(kCone, {0.5, 0, 0.5}, 0) - dvec3(1, 0, 1) / std::sqrt(2.0)) <
        1e-15);
  CHECK(outward_normal(kCone, {0, 0, 1}, 0) == dvec3(0, 0, 1)); // the tip
  CHECK(outward_normal(kCone, {0, 0, 0}, 1) == dvec3(0, 0, -1));
  CHECK(snapped(kCylinder, {0, 2, 0.5}, 0) == dvec3(0, 1, 0.5));
  CHECK(snapped(kCylinder, {0.5, 0, 0.99}, 2) == dvec3(0.5, 0, 1));
  CHECK(glm::length(snapped(kCone, {1, 0, 1}, 0) - dvec3(0.5, 0, 0.5)) < 1e-15);
  CHECK(signed_distance(kCylinder, {0, 0, 0.5}) == -0.5);
  CHECK(signed_distance(kCylinder, {3, 0, 0.5}) == 2.0);
  CHECK(nearest_face(kCylinder, {0.1, 0, 0.9}, {1, 0, 1}) == 2);
  CHECK(nearest_face(kCylinder, {0.95, 0, 0.9}, {1, 0, 1}) == 0);
  CHECK(nearest_face(kCylinder, {0.95, 0, 0.9}, {-1, 0, 1}) == 2); // it runs into the side
  CHECK(nearest_face(kCylinder, {0.1, 0, 0.9}, {1, 0, 0}) == 2);
  const Bounds box = bounds(kFunnel, Transform::scaling({1, 2, -3}));
  CHECK(box.lower == dvec3(-2, -4, -3));
  CHECK(box.upper == dvec3(2, 4, 0));
}
