#include "bench/measurements/setup.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <string>

using namespace abbe;

// How many rays an image takes, where that can be counted by hand: what the work is, on any
// machine. 8 x 8 pixels with 4 samples.

namespace {

constexpr std::uint64_t kSamples = 8 * 8 * 4;

RayCounts counts_of(const std::string& text, bool exact = false, int bands = 81) {
  Scene scene =
      test::scene_from("imageSize 8 8 samples 4 fieldOfView 1 filter box eye 0 0 5 " + text);
  scene.settings.exact = exact;
  scene.settings.bands = bands;
  return test::render_scene(scene, false).rays;
}

} // namespace

TEST_CASE("a card takes a camera ray and a shadow ray for each light") {
  const RayCounts c = counts_of("background D65 1 light D65 0 3 5 1 light D65 3 0 5 1\n"
                                "diffuse 0.5 0.5 0.5 square");
  CHECK(c.camera == kSamples);
  CHECK(c.shadow == 2 * kSamples);
  CHECK(c.total() == 3 * kSamples);
}

TEST_CASE("an image of the background takes no rays, unless nothing is skipped") {
  const std::string text = "background D65 1 translate 50 0 0 square";
  CHECK(counts_of(text).total() == 0);
  Scene scene = test::scene_from("imageSize 8 8 samples 4 fieldOfView 1 " + text);
  scene.settings.skip = false;
  CHECK(test::render_scene(scene, false).rays.camera == kSamples);
}

TEST_CASE("a mirror takes a reflected ray") {
  const RayCounts c = counts_of("background D65 1 ambient 0 0 0 diffuse 0 0 0 specular 0 0 0\n"
                                "reflectivity 1 fresnel off square");
  CHECK(c.reflected == kSamples);
  CHECK(c.total() == 2 * kSamples);
}

// Looked through square on, a plate with R = ((n - 1) / (n + 1))^2 near 0.04 at each face throws
// back R, lets in T = 1 - R, and keeps T R^k behind the k-th face inside. Ways that carry less than
// 1e-3 are left to chance: T R^2 = 1.6e-3 is followed once more, and so is what leaves of it,
// T^2 R^2; T R^3 = 6e-5 with the chance 0.06. So there are 1 + 2 reflected rays for sure, and
// 1 + 3 refracted ones. A fan of as many sub-bundles as bands leaves nothing else to chance.

namespace {

/// So many rays of a sample for sure, and more by no more than 2.3 times the mean of T R^3 / 1e-3,
/// which is four standard deviations of the samples' mean.
bool about(std::uint64_t rays, double sure, double ways = 1.0) {
  const double of_sample = static_cast<double>(rays) / kSamples;
  return of_sample >= sure && of_sample <= sure + 0.15 * ways;
}

} // namespace

TEST_CASE("a plate without dispersion takes three reflected and four refracted rays") {
  const std::string plate = "background D65 1 maxFan 81 ambient 0 0 0 diffuse 0 0 0\n"
                            "specular 0 0 0 transparency 1 reflectivity 1 speedOfLight 1.5 vnum 0\n"
                            "scale 1 1 0.1 cube";
  for (const int bands : {1, 81})
    for (const bool exact : {false, true}) {
      const RayCounts c = counts_of(plate, exact, bands);
      CHECK(c.camera == kSamples);
      CHECK(about(c.reflected, 3.0));
      CHECK(about(c.refracted, 4.0));
    }
}

TEST_CASE("exactly, each band takes its rays through a plate; bundles take a tenth at most") {
  const std::string plate = "background D65 1 glass N-BK7 scale 1 1 0.1 cube";
  const RayCounts exact = counts_of(plate, true);
  CHECK(about(exact.reflected, 1 + 81 * 2, 81));
  CHECK(about(exact.refracted, 81 * 4, 81));
  const RayCounts bundled = counts_of(plate + " maxFan 81");
  CHECK(about(bundled.reflected, 3));       // they stay together
  CHECK(bundled.refracted >= 4 * kSamples); // some to see that they may
  CHECK(10 * bundled.total() <= exact.total());
  CHECK(counts_of(plate).total() <= bundled.total()); // fewer where chance decides
}

TEST_CASE("inside a grey box a path goes on as often as it may") {
  const std::string box = "integrator path background D65 1 maxRecursionDepth 3\n"
                          "diffuse 0.5 0.5 0.5 ambient 0 0 0 scale 20 20 20 cube";
  const RayCounts c = counts_of(box);
  CHECK(c.camera == kSamples);
  CHECK(c.scattered == 3 * kSamples);
  CHECK(c.total() == 4 * kSamples);
}
