#include "core/integrators/random_walk.h"
#include "tests/catch.h"
#include "tests/core/integrators/walk_scene.h"

#include <cmath>

using namespace abbe;
using test::WalkScene;

namespace {

struct Walk : RandomWalk {
  explicit Walk(WalkScene& s) : RandomWalk(s.plan, s.world, 1e-3, Transport::radiance) {}
  /// Brings a bundle to the first surface that it meets, with this throughput in all bands.
  void start(const Sampler& sampler, const Bundle& first, WalkScene& s, float value = 1.0f) {
    begin(sampler, s.counts);
    bundle() = first;
    for (int b = first.bands.first; b < first.bands.last; ++b)
      throughput()[b] = value;
    extend();
    REQUIRE(bundle().hit.met());
    (void)find_material();
    prepare_scattering();
  }
  using RandomWalk::begin, RandomWalk::extend, RandomWalk::find_material, RandomWalk::reflect;
  using RandomWalk::bundle, RandomWalk::take, RandomWalk::throughput;
  using RandomWalk::refract, RandomWalk::scatter;
};

const std::string kMirror = "background E 1 reflectivity 0.6 fresnel off diffuse 0 0 0\n"
                            "push scale 50 50 1 square pop ";

} // namespace

TEST_CASE("a reflection that was chosen by chance weighs as much the more") {
  WalkScene s(kMirror);
  Walk walk(s);
  const Sampler sampler(0, 0, 0, 0);
  walk.start(sampler, s.bundle_from({0, 0, 4}, {0, 0, -1}), s);
  walk.reflect(0.5);
  REQUIRE(walk.take());
  CHECK(walk.throughput()[40] == Approx(0.6 / 0.5));
  CHECK(walk.bundle().pdf == 0.0);
  CHECK(walk.bundle().nonspecular_bounces == 0);
  CHECK_FALSE(walk.bundle().traced);
  CHECK_FALSE(walk.take());
}

TEST_CASE("a bundle that is scattered knows its pdf, and its pixel's width no more") {
  WalkScene s("background E 1 diffuse 0.5 0.5 0.5 push scale 50 50 1 square pop");
  Walk walk(s);
  const Sampler sampler(0, 0, 0, 0);
  Bundle first = s.bundle_from({0, 0, 4}, {0, 0, -1});
  first.depth = 2;
  first.separation = first.divergence = 0.1;
  walk.start(sampler, first, s);
  const std::vector<float> f_cos(96, 0.25f);
  walk.scatter({0.6, 0.0, 0.8}, f_cos.data(), 0.5, 2.0);
  REQUIRE(walk.take());
  const Bundle& b = walk.bundle();
  CHECK(walk.throughput()[40] == Approx(0.25 / 0.5 * 2.0));
  CHECK(b.pdf == 0.5);
  CHECK(b.nonspecular_bounces == 1);
  CHECK(b.first_nonspecular_depth == 2);
  CHECK(b.depth == 3);
  CHECK_FALSE(b.has_pixel_footprint);
  CHECK(b.separation == 0.0);
  CHECK(b.divergence == 0.0);
  walk.extend();
  CHECK(s.counts.scattered == 1);
  CHECK_FALSE(b.hit.met()); // it left on the side that it came from
}

// Of paths that matter 0.3 each, three in ten go on, as if they mattered 1.
TEST_CASE("Russian roulette keeps the mean, from the fifth surface on") {
  WalkScene s(kMirror);
  Walk walk(s);
  constexpr int kPaths = 4096;
  for (const int depth : {4, 5}) {
    int kept = 0;
    for (int i = 0; i < kPaths; ++i) {
      const Sampler sampler(0, 0, static_cast<std::uint32_t>(i), 3);
      Bundle first = s.bundle_from({0, 0, 4}, {0, 0, -1});
      first.depth = depth;
      walk.start(sampler, first, s, 0.5f);
      walk.reflect(1.0); // leaves 0.3
      if (!walk.take()) continue;
      ++kept;
      REQUIRE(walk.throughput()[40] == Approx(depth < 5 ? 0.3 : 1.0));
    }
    if (depth < 5)
      CHECK(kept == kPaths);
    else // four standard deviations of a binomial count
      CHECK(std::abs(kept - 0.3 * kPaths) < 4.0 * std::sqrt(kPaths * 0.3 * 0.7));
  }
}

TEST_CASE("nothing goes on behind a surface that reflects all") {
  // From inside, at 60 degrees, far beyond the critical angle of 41.8.
  WalkScene s("background E 1 transparency 1 reflectivity 1 speedOfLight 1.5 diffuse 0 0 0\n"
              "push translate 0 0 -50 scale 50 50 50 cube pop");
  Walk walk(s);
  const Sampler sampler(0, 0, 0, 0);
  walk.start(sampler, s.bundle_from({0, 0, -1}, {std::sqrt(3.0), 0, 1}), s);
  walk.refract(1.0);
  CHECK_FALSE(walk.take());
}
