#include "core/bands/passing_runs.h"
#include "core/integrators/bundle_walk.h"
#include "tests/catch.h"
#include "tests/core/integrators/walk_scene.h"

#include <cmath>

using namespace abbe;
using test::WalkScene;

namespace {

struct Walk : BundleWalk {
  explicit Walk(WalkScene& s, Transport transport = Transport::radiance)
      : BundleWalk(s.plan, s.world, 1e-3, transport) {
    begin_path({0.5, 0.5}, s.counts);
  }
  /// Sets a bundle on its way with this throughput in all bands, and traces it.
  void start(const Bundle& first, float value = 1.0f) {
    bundle() = first;
    for (int b = first.bands.first; b < first.bands.last; ++b)
      throughput()[b] = value;
    extend();
  }
  using BundleWalk::branch_off_reflection, BundleWalk::branch_off_refraction;
  using BundleWalk::bundle, BundleWalk::branch_off, BundleWalk::extend, BundleWalk::importance;
  using BundleWalk::scale, BundleWalk::share, BundleWalk::take, BundleWalk::throughput;
  using BundleWalk::wait, BundleWalk::wavelengths_;
};

const std::string kLight = "background E 1 ";
/// A solid below z = 0 of this material.
std::string half_space(const std::string& material) {
  return kLight + material + " push translate 0 0 -50 scale 50 50 50 cube pop ";
}

} // namespace

TEST_CASE("bundles go on in the reverse of the order in which they came to wait") {
  WalkScene s(kLight);
  Walk walk(s);
  walk.start(s.bundle_from({0, 0, 1}, {0, 0, -1}));
  walk.bundle().depth = 1;
  (void)walk.branch_off({0, 81}, std::vector<float>(96, 1.0f).data(), 1.0);
  walk.wait();
  REQUIRE(walk.take());
  CHECK(walk.bundle().depth == 1); // it waits as it was
  REQUIRE(walk.take());
  CHECK_FALSE(walk.take());
}

TEST_CASE("what branches off carries the throughput times its factors and its weight") {
  WalkScene s(kLight);
  Walk walk(s);
  walk.start(s.bundle_from({0, 0, 1}, {0, 0, -1}), 0.5f);
  std::vector<float> factors(96, 0.0f);
  for (std::size_t b = 20; b < 30; ++b)
    factors[b] = 0.25f;
  (void)walk.branch_off({20, 30}, factors.data(), 3.0);
  CHECK(walk.throughput()[25] == 0.5f); // the bundle itself stays as it is
  walk.scale(factors.data(), 2.0);
  CHECK(walk.throughput()[25] == 0.25f);
  CHECK(walk.throughput()[5] == 0.0f);
  REQUIRE(walk.take());
  CHECK(walk.bundle().bands.first == 20);
  CHECK(walk.bundle().bands.last == 30);
  for (int b = 20; b < 30; ++b)
    CHECK(walk.throughput()[b] == 0.375f);
}

TEST_CASE("a reflection goes off as from a mirror, and is traced no earlier than asked") {
  WalkScene s(half_space("reflectivity 1"));
  Walk walk(s);
  walk.start(s.bundle_from({-3, 0, 4}, {3, 0, -4}));
  REQUIRE(walk.bundle().hit.t == Approx(5.0));
  walk.branch_off_reflection(std::vector<float>(96, 0.5f).data(), 1.0);
  CHECK(s.counts.reflected == 0);
  REQUIRE(walk.take());
  const Bundle& b = walk.bundle();
  CHECK(glm::distance(b.state.ray.origin, dvec3(0.0)) < 1e-12);
  CHECK(glm::distance(b.state.ray.direction, dvec3(0.6, 0.0, 0.8)) < 1e-12);
  CHECK(b.depth == 1);
  CHECK(b.path_length == Approx(5.0));
  walk.extend();
  CHECK(s.counts.reflected == 1);
  CHECK_FALSE(b.hit.met());
}

// Snell's law: sin t = sin i / n, and the transmitted ray leaves below.
TEST_CASE("each band is refracted by its own index, and the highest goes on first") {
  WalkScene s(half_space("glass SF11") + "exact on");
  Walk walk(s);
  walk.start(s.bundle_from({-3, 0, 4}, {3, 0, -4}), 0.5f);
  walk.branch_off_refraction({10, 20}, 1.0);
  const double* n = walk.wavelengths_.indices(MediumId{0});
  for (int band = 19; band >= 10; --band) {
    REQUIRE(walk.take());
    const Bundle& b = walk.bundle();
    CHECK(b.bands.first == band);
    CHECK(b.bands.size() == 1);
    CHECK(b.state.ray.direction.x == Approx(0.6 / n[band]).epsilon(1e-12));
    CHECK(b.state.ray.direction.z < 0.0);
    CHECK(walk.throughput()[band] == 0.5f);
  }
  CHECK_FALSE(walk.take());
  CHECK(s.counts.refracted == 10);
}

TEST_CASE("a single refracted ray waits untraced") {
  for (const char* material : {"transparency 1 speedOfLight 1.5", "glass SF11"}) {
    WalkScene s(half_space(material));
    Walk walk(s);
    walk.start(s.bundle_from({-3, 0, 4}, {3, 0, -4}));
    const bool disperses = s.plan.disperses;
    walk.branch_off_refraction(disperses ? BandRange{40, 41} : BandRange{0, 81}, 1.0);
    CHECK(s.counts.refracted == 0);
    REQUIRE(walk.take());
    CHECK(walk.bundle().bands.size() == (disperses ? 1 : 81));
    walk.extend();
    CHECK(s.counts.refracted == 1);
    CHECK(walk.bundle().hit.met()); // the far side of the solid
  }
}

TEST_CASE("radiance is worth n^2 in a medium of index n, and flux is not") {
  WalkScene s(half_space("transparency 1 speedOfLight 1.5"));
  const MediumId glass{0}, air{};
  Walk radiance(s), flux(s, Transport::flux);
  CHECK(radiance.importance(0.5f, 0, glass) == Approx(0.5 * 2.25));
  CHECK(radiance.importance(0.5f, 0, air) == 0.5);
  CHECK(flux.importance(0.5f, 0, glass) == 0.5);
  radiance.start(s.bundle_from({0, 0, 1}, {0, 0, -1}), 0.25f);
  radiance.throughput()[30] = 0.75f;
  CHECK(radiance.importance(air) == 0.75); // the largest of the bands
}

TEST_CASE("bands that carry no light do not change what a bundle matters") {
  // Filter 2a is dark at the blue end, where the index is highest.
  WalkScene s("lights " ABBE_SOURCE_DIR "/scenes/lights.filter\n"
              "light 2a 3 4 5 1 glass SF11 dispersionScale 3 sphere",
              false);
  Walk walk(s);
  const int live = s.plan.live_first;
  REQUIRE(live > 0);
  REQUIRE(s.plan.first_band == 0);
  const MediumId glass{0};
  const double* n = walk.wavelengths_.indices(glass);
  REQUIRE(n[0] > n[live]);
  CHECK(walk.importance(1.0f, 0, glass) == walk.importance(1.0f, live, glass));
  CHECK(walk.importance(1.0f, live, glass) == n[live] * n[live]);
  CHECK(walk.importance(1.0f, live + 5, glass) == n[live + 5] * n[live + 5]);
  CHECK(walk.share(0.5, {0, 81}) == Approx(0.5));
  CHECK(walk.share(0.5, {0, live}) == 0.0);
}
