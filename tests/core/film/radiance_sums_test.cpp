#include "core/film/radiance_sums.h"
#include "core/planning/make_plan.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <vector>

using namespace abbe;

namespace {

/// Two lights over a black background, under so many bands.
Plan two_lights(int bands, bool skip = true) {
  Scene scene;
  scene.lights = {{"", Curve::table({380.0, 780.0}, {0.2, 1.0}), PointLight{}},
                  {"", Curve::constant(0.5), PointLight{}}};
  RenderSettings settings;
  settings.bands = bands;
  settings.skip = skip;
  return make_plan(scene, settings);
}

} // namespace

TEST_CASE("full throughput from a light has the light's colour and its mean radiance per band") {
  for (const int bands : {1, 9, 27, 81, 100, 405}) {
    const Plan plan = two_lights(bands);
    RadianceSums sums(plan);
    const std::vector<float> ones(plan.stride, 1.0f);
    sums.add(plan.light_source(0), {ones.data(), {0, bands}}, BandTable(1.0f, bands), 1.0f);
    const Curve light = Curve::table({380.0, 780.0}, {0.2, 1.0});
    Xyz white;
    for (const Xyz& w : band_weights(plan.grid, light))
      white += w;
    CHECK(sums.color().x == Approx(white.x).epsilon(1e-6));
    CHECK(sums.color().y == Approx(white.y).epsilon(1e-6));
    CHECK(sums.color().z == Approx(white.z).epsilon(1e-6));
    const auto means = band_means(plan.grid, light);
    const auto radiance = sums.radiance();
    REQUIRE(radiance.size() == means.size());
    for (std::size_t b = 0; b < means.size(); ++b)
      REQUIRE(radiance[b] == Approx(means[b]).epsilon(1e-6));
  }
}

TEST_CASE("what lights give adds up, times throughput, reflectance and factor") {
  for (const int bands : {27, 81}) {
    const Plan plan = two_lights(bands);
    RadianceSums sums(plan);
    const std::vector<float> half(plan.stride, 0.5f);
    sums.add(plan.light_source(0), {half.data(), {0, bands}}, BandTable(0.4f, bands), 3.0f);
    sums.add(plan.light_source(1), {half.data(), {5, 6}}, BandTable(1.0f, bands), 1.0f);
    const auto means = band_means(plan.grid, Curve::table({380.0, 780.0}, {0.2, 1.0}));
    CHECK(sums.radiance()[4] == Approx(0.5 * 0.4 * 3.0 * means[4]).epsilon(1e-6));
    CHECK(sums.radiance()[5] == Approx(0.5 * 0.4 * 3.0 * means[5] + 0.25).epsilon(1e-6));
    sums.clear();
    CHECK(sums.color() == Xyz{0.0, 0.0, 0.0});
    CHECK(sums.radiance()[5] == 0.0f);
  }
}

TEST_CASE("a constant light adds the same bytes whether or not constants are skipped") {
  const BandTable reflectance(std::vector<double>(81, 0.3));
  std::vector<float> result[2];
  for (const bool skip : {false, true}) {
    const Plan plan = two_lights(81, skip);
    RadianceSums sums(plan);
    const std::vector<float> throughput(plan.stride, 0.7f);
    for (const int source : {plan.light_source(1), Plan::kBackground})
      sums.add(source, {throughput.data(), {0, 81}}, reflectance, 0.9f);
    const auto radiance = sums.radiance();
    result[skip ? 1 : 0].assign(radiance.begin(), radiance.end());
  }
  CHECK(result[0] == result[1]);
}
