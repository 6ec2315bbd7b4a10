#include "core/integrators/light_paths.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/physics/newton_scene.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

TEST_CASE("each band of Newton's spectrum lands where Snell sends it, with what Fresnel leaves") {
  const Scene scene = test::scene_from(test::kNewtonScene);
  RenderSettings settings = scene.settings;
  settings.jitter = false;
  settings.max_fan = 32;
  const Plan plan = make_plan(scene, settings);
  REQUIRE(plan.caustics);
  const World world(scene.shapes, farthest_coordinate(scene));
  Emission emission(scene, plan);
  emission.place(world);
  REQUIRE(emission.lights().size() == 1);
  Film film({0, 0, 1, 1}, 1.0, 0);
  LightPaths paths(plan, world, emission, nullptr, film);
  PhotonBatch batch;
  RayCounts counts;
  constexpr std::uint32_t kPaths = 1u << 17;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    const Sampler sampler(0, 0, i, 7);
    if (const auto ray = emission.lights()[0].sample(sampler))
      paths.trace(*ray, sampler, 1.0 / kPaths, &batch, 1.0 / kPaths, counts);
  }
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const test::NewtonArrival arrival =
        test::newton_arrival(refractive_index(find_glass("SF11")->dispersion, nm));
    double flux = 0.0, moment = 0.0;
    for (const Photon& photon : batch.photons) {
      if (b < photon.bands.first || b >= photon.bands.last) continue;
      if (std::abs(photon.position.x - test::kNewtonWall) > 1e-9) continue;
      if (std::abs(photon.position.y - arrival.y) > 0.03) continue;
      const auto value = static_cast<double>(
          batch.flux[photon.flux + static_cast<std::size_t>(b - photon.bands.first)]);
      flux += value;
      moment += value * photon.position.y;
    }
    INFO(nm << " nm");
    // The beam is 0.007 wide there, and each band has a tenth of the paths or more: some
    // 10000 photons.
    CHECK(moment / flux == Approx(arrival.y).margin(2e-4));
    CHECK(flux == Approx(test::kNewtonBeam * arrival.transmittance).epsilon(0.02));
  }
}
