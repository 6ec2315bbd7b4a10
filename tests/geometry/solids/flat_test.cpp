#include "geometry/solids/flat.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

std::optional<Root> line(const dvec3& origin, const dvec3& direction) {
  return intersect(Square{}, LocalRay{origin, direction});
}

} // namespace

TEST_CASE("square: met from both sides, missed beside it") {
  REQUIRE(line({0.5, -0.5, 3}, {0, 0, -2})->t == 1.5);
  REQUIRE(line({0.5, -0.5, -3}, {0, 0, 2})->t == 1.5);
  REQUIRE(line({0.5, -0.5, 3}, {0, 0, 1})->t == -3.0);
  REQUIRE_FALSE(line({1.5, 0, 3}, {0, 0, -1}));
  REQUIRE_FALSE(line({0, -1.5, 3}, {0, 0, -1}));
  REQUIRE(line({1, 1, 3}, {0, 0, -1})); // its corner belongs to it
}

TEST_CASE("square: a ray in its plane sees nothing of it") {
  REQUIRE_FALSE(line({-3, 0, 0}, {1, 0, 0}));
  REQUIRE_FALSE(line({0, 0, 0}, {1, 0, 0}));
  REQUIRE_FALSE(line({-3, 0, 1e-9}, {1, 0, 0}));
}

TEST_CASE("square: grazing, far away, on the surface") {
  // Height 1 over a run of 2^20: t is exact.
  const double run = 1048576.0;
  REQUIRE(line({-run, 0, 1}, {run, 0, -1})->t == 1.0);
  REQUIRE(line({0, 0, 1e6}, {0, 0, -1})->t == 1e6);
  REQUIRE(line({0.25, 0.25, 0}, {0, 0.6, 0.8})->t == 0.0);
}

TEST_CASE("square: normal, snapping, bounds") {
  REQUIRE(outward_normal(Square{}, {0, 0, 0}, 0) == dvec3(0, 0, 1));
  REQUIRE(snapped(Square{}, {0.5, 0.25, 1e-9}, 0) == dvec3(0.5, 0.25, 0));
  const Bounds box = bounds(Square{}, Transform::translation({1, 2, 3}));
  REQUIRE(box.lower == dvec3(0, 1, 3));
  REQUIRE(box.upper == dvec3(2, 3, 3));
}

TEST_CASE("disc: its rim belongs to it, what is beyond does not") {
  const auto met = [](double x, double y) {
    return intersect(Disc{}, LocalRay{{x, y, 3}, {0, 0, -1}}).has_value();
  };
  REQUIRE(met(0, 0));
  REQUIRE(met(0.6, 0.8));
  REQUIRE(met(0, -1));
  REQUIRE_FALSE(met(0, 1 + 1e-15));
  REQUIRE_FALSE(met(0.8, 0.8));
  const Bounds box = bounds(Disc{}, Transform::rotation(90, {0, 1, 0}));
  REQUIRE(box.lower == dvec3(0, -1, -1));
  REQUIRE(box.upper == dvec3(0, 1, 1));
}

TEST_CASE("plane: met anywhere, but not by a ray in it") {
  REQUIRE(intersect(Plane{}, LocalRay{{1e9, -1e9, 3}, {0, 0, -1}})->t == 3.0);
  REQUIRE(intersect(Plane{}, LocalRay{{0, 0, 1}, {1, 0, -1e-9}})->t == Approx(1e9));
  REQUIRE_FALSE(intersect(Plane{}, LocalRay{{0, 0, 0}, {1, 0, 0}}));
  REQUIRE_FALSE(intersect(Plane{}, LocalRay{{0, 0, 1}, {1, 0, 0}}));
}

TEST_CASE("plane: where a line runs along it within rounding, nothing is met before it may be") {
  // The line comes down by 1e-30 a unit from a height of 1, and rounding moves it by some 1e-15 a
  // unit. So the root may be anywhere from some 1e15 on; its bound must have digits to say so.
  for (const double sign : {1.0, -1.0}) {
    const auto root = intersect(Plane{}, LocalRay{{0, 0, 1}, {1, 0, -sign * 1e-30}});
    REQUIRE(root);
    const double nearest = sign * root->t - root->t_error;
    CHECK(nearest > 1e14);
    CHECK(nearest < 1e16);
    CHECK(sign * root->t + root->t_error < 1e17);
  }
  // With the height of rounding itself, it may be met from the origin on.
  const auto close = intersect(Plane{}, LocalRay{{0, 0, 1e-16}, {1, 0, -1e-30}});
  CHECK(close->t - close->t_error <= 0.0);
}
