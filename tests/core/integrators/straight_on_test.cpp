#include "core/bundles/extend.h"
#include "core/integrators/straight_on.h"
#include "tests/catch.h"
#include "tests/core/integrators/walk_scene.h"

using namespace abbe;
using test::WalkScene;

TEST_CASE("through a boundary that is not seen a ray goes straight on, and keeps what it was") {
  WalkScene s(
      "light E 1 0 0 0 drops 0.4 dropIndex 1.3333 dropSun 0 push translate 0 0 -3 cube pop");
  Bundle bundle = s.bundle_from({0, 0, 0}, {0, 0, -1});
  bundle.depth = 2;
  bundle.pdf = 0.5;
  bundle.nonspecular_bounces = 1;
  bundle.path_length = 7.0;
  bundle.divergence = 0.01;
  extend(bundle, s.world, s.counts);
  REQUIRE(bundle.hit.met());
  REQUIRE(s.plan.unseen(bundle.hit));
  for (const double length : {2.0, 4.0}) { // into the drops, and out of them
    go_straight_on(bundle);
    CHECK_FALSE(bundle.traced);
    CHECK(bundle.unseen_length == Approx(length));
    CHECK(bundle.path_length == Approx(7.0 + length));
    CHECK(bundle.separation == Approx(0.01 * length));
    extend(bundle, s.world, s.counts);
  }
  CHECK_FALSE(bundle.hit.met());
  CHECK(bundle.state.ray.direction == dvec3(0.0, 0.0, -1.0));
  CHECK(bundle.state.nesting.empty());
  CHECK(bundle.depth == 2); // it is no surface
  CHECK(bundle.pdf == 0.5);
  CHECK(bundle.nonspecular_bounces == 1);
  CHECK(s.counts.refracted == 2);
}
