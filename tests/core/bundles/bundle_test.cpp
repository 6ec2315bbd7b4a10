#include "core/bundles/extend.h"
#include "core/planning/plan_extent.h"
#include "tests/catch.h"
#include "tests/render_text.h"

using namespace abbe;

namespace {

/// A bundle that has met the plane z = 0 after a distance of 5, at the angle whose cosine is 0.8.
struct AtPlane {
  Scene scene = test::scene_from("push scale 99 99 1 square pop");
  World world{scene.shapes, farthest_coordinate(scene)};
  RayCounts counts;
  Bundle bundle;

  AtPlane() {
    bundle.bands = {10, 20};
    bundle.state.ray = {{0.0, 0.0, 4.0}, {0.6, 0.0, -0.8}};
    extend(bundle, world, counts);
  }
};

} // namespace

TEST_CASE("a bundle's ray is traced and counted once, by its kind") {
  AtPlane s;
  CHECK(s.counts.camera == 1);
  CHECK(s.bundle.traced);
  REQUIRE(s.bundle.hit.met());
  CHECK(s.bundle.hit.t == Approx(5.0));
  extend(s.bundle, s.world, s.counts);
  CHECK(s.counts.total() == 1);
  set_off(s.bundle, {0.0, 0.0, 1.0}, false, RayKind::reflected, s.bundle);
  CHECK_FALSE(s.bundle.traced);
  extend(s.bundle, s.world, s.counts);
  CHECK(s.counts.reflected == 1);
  CHECK(s.counts.total() == 2);
  CHECK_FALSE(s.bundle.hit.met());
}

TEST_CASE("a bundle that sets off takes along how far it has come and how far its bands drift") {
  AtPlane s;
  Bundle& from = s.bundle;
  from.path_length = 2.0;
  from.unseen_length = 0.5;
  from.depth = 3;
  from.pdf = 0.7;
  from.nonspecular_bounces = 2;
  from.first_nonspecular_depth = 1;
  from.has_pixel_footprint = false;
  from.separation = 0.01;
  from.divergence = 0.002;
  const dvec3 direction{0.6, 0.0, 0.8};
  Bundle next;
  next.pdf = next.unseen_length = 9.0; // what was there before is of no use
  next.traced = true;
  set_off(from, direction, false, RayKind::reflected, next);
  CHECK(next.state.ray.origin == from.hit.point);
  CHECK(next.state.ray.direction == direction);
  CHECK(next.path_length == Approx(7.0));
  CHECK(next.unseen_length == 0.0);
  CHECK(next.depth == 4);
  CHECK(next.pdf == 0.0); // a specular step, unless the caller knows better
  CHECK(next.nonspecular_bounces == 2);
  CHECK(next.first_nonspecular_depth == 1);
  CHECK_FALSE(next.has_pixel_footprint);
  CHECK(next.separation == Approx(0.01 + 5.0 * 0.002));
  CHECK(next.divergence == 0.002);
  CHECK(next.kind == RayKind::reflected);
  CHECK_FALSE(next.traced);
  CHECK(from.depth == 3);
}

TEST_CASE("a bundle that sets off leaves the surface on the side to which it goes") {
  for (const bool through : {false, true}) {
    AtPlane s;
    const Contacts expected = s.bundle.hit.going_on({}, through).contacts;
    set_off(s.bundle, {0.6, 0.0, through ? -0.8 : 0.8}, through, RayKind::refracted, s.bundle);
    REQUIRE(s.bundle.state.contacts.size() == expected.size());
    CHECK(s.bundle.state.contacts[0].side == expected[0].side);
    extend(s.bundle, s.world, s.counts);
    CHECK_FALSE(s.bundle.hit.met()); // not the plane again
  }
}

TEST_CASE("a path remembers whether it has come through, or been sent back, and by what") {
  using enum Route;
  for (const Route route : {direct, reflected, through})
    CHECK(let_through(route) == through);
  CHECK(let_through(opaque) == opaque);
  CHECK(sent_back(direct, true) == reflected);
  CHECK(sent_back(reflected, true) == reflected);
  CHECK(sent_back(through, true) == through);
  for (const Route route : {direct, reflected, through, opaque})
    CHECK(sent_back(route, false) == opaque);
  AtPlane s;
  s.bundle.route = reflected;
  Bundle next;
  set_off(s.bundle, {0.0, 0.0, -1.0}, true, RayKind::refracted, next);
  CHECK(next.route == through);
  set_off(s.bundle, {0.0, 0.0, 1.0}, false, RayKind::reflected, next);
  CHECK(next.route == reflected);
}

TEST_CASE("a camera's bundles start traced, on no surface, with their own drift") {
  AtPlane s;
  const CameraBundle starts[2] = {{{0, 5}, 0.5f}, {{5, 81}, 0.25f, 0.1, 0.2}};
  const RayState states[2] = {{}, s.bundle.state};
  const Hit hits[2] = {{}, s.bundle.hit};
  const CameraPaths paths{starts, states, hits, 2};
  Bundle bundle = s.bundle;
  bundle.depth = bundle.nonspecular_bounces = 9;
  bundle.has_pixel_footprint = false;
  bundle.kind = RayKind::scattered;
  bundle.pdf = bundle.path_length = bundle.unseen_length = 9.0;
  bundle.route = Route::opaque;
  paths.begin(1, bundle);
  CHECK(bundle.route == Route::direct);
  CHECK(bundle.bands.first == 5);
  CHECK(bundle.bands.last == 81);
  CHECK(bundle.hit.point == s.bundle.hit.point);
  CHECK(bundle.traced);
  CHECK(bundle.kind == RayKind::camera);
  CHECK(bundle.depth == 0);
  CHECK(bundle.nonspecular_bounces == 0);
  CHECK(bundle.has_pixel_footprint);
  CHECK(bundle.pdf == 0.0);
  CHECK(bundle.path_length == 0.0);
  CHECK(bundle.unseen_length == 0.0);
  CHECK(bundle.separation == 0.1);
  CHECK(bundle.divergence == 0.2);
}
