#include "core/integrators/light_paths.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/catch.h"
#include "tests/seeds.h"

using namespace abbe;

namespace {

/// The flux of all bands that a scene's light paths bring to surfaces that scatter it, and the flux
/// that met the glass in the first place.
struct Flux {
  double emitted = 0.0, arrived = 0.0;
};

Flux followed(const std::string& text) {
  const Scene scene = test::scene_from("integrator path\n" + text);
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  Emission emission(scene, plan);
  emission.place(world);
  Film film({0, 0, 1, 1}, 1.0, 0);
  LightPaths paths(plan, world, emission, nullptr, film);
  PhotonBatch batch;
  RayCounts counts;
  Flux flux;
  constexpr std::uint32_t kPaths = 1 << 14;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    const Sampler sampler(0, 0, i, 3);
    const auto ray = emission.lights().at(0).sample(sampler);
    if (!ray) continue;
    const auto hit = world.closest(ray->state);
    if (hit && plan.materials[hit->material.index()].facts().specular())
      flux.emitted += ray->flux / kPaths;
    paths.trace(*ray, sampler, 1.0 / kPaths, &batch, 1.0 / kPaths, counts);
  }
  for (const float value : batch.flux)
    flux.arrived += static_cast<double>(value) / 81.0;
  return flux;
}

const char* const kWhiteBox = "defaultMaterials diffuse 0.9 0.9 0.9\n"
                              "push scale 4 4 4\n"
                              "def wall { push translate 0 0 -1 square pop }\n"
                              "use wall rotate 180 0 1 0 use wall rotate 90 0 1 0 use wall\n"
                              "rotate 180 0 1 0 use wall\n"
                              "rotate 90 1 0 0 use wall rotate 180 1 0 0 use wall pop\n";

} // namespace

TEST_CASE("what enters a ball of clear glass arrives on the walls") {
  const Flux flux =
      followed(std::string("maxRecursionDepth 200 falloff square light E 1 2 1.5 1\n") + kWhiteBox +
               "glass SF11 sphere");
  CHECK(flux.emitted > 0.1);
  CHECK(flux.arrived == Approx(flux.emitted).epsilon(0.005));
}

TEST_CASE("what meets a mirror arrives on the walls") {
  const Flux flux = followed(std::string("falloff square light E 1 2 1.5 1\n") + kWhiteBox +
                             "defaultMaterials diffuse 0 0 0 specular 0 0 0 reflectivity 1 sphere");
  CHECK(flux.arrived == Approx(flux.emitted).epsilon(1e-5));
}

TEST_CASE("light paths and camera paths alone make the same caustic") {
  // A ball of glass over a floor, lit by a ball; the camera sees the floor below it and neither.
  Scene scene = test::scene_from("integrator path maxRecursionDepth 12\n"
                                 "eye 0 0.4 3 lookAt 0 -1 0 fieldOfView 22\n"
                                 "imageSize 12 12 samples 64\n"
                                 "defaultMaterials diffuse 0 0 0 specular 0 0 0 emissive E 3\n"
                                 "push translate 0.3 2.2 0 scale 0.5 0.5 0.5 sphere pop\n"
                                 "defaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
                                 "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
                                 "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop");
  scene.settings.caustics = Caustics::off;
  const auto camera = test::over_seeds(scene, 96);
  scene.settings.caustics = Caustics::automatic;
  scene.settings.samples_per_pixel = 16;
  scene.settings.light_paths = 8.0;
  const auto both = test::over_seeds(scene, 96);
  // The mean over 144 pixels strays by 0.12, and more for the long tails of camera paths.
  CHECK(mean_square_z(camera, both) < 1.4);
  CHECK(std::abs(total_z(camera, both)) < 4.0);
}

TEST_CASE("caustics seen in a mirror and lighting a wall are those of camera paths alone") {
  // The same floor, seen in a mirror: photons are looked up there. A wall beside it gets light
  // from the caustic.
  Scene scene = test::scene_from("integrator path maxRecursionDepth 12 photonRadius 0.1\n"
                                 "eye 0 0.4 3 lookAt 0 0.2 -1 fieldOfView 24\n"
                                 "imageSize 8 8 samples 128\n"
                                 "defaultMaterials diffuse 0 0 0 specular 0 0 0 emissive E 3\n"
                                 "push translate 0.3 2.2 0 scale 0.5 0.5 0.5 sphere pop\n"
                                 "defaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
                                 "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
                                 "push translate -1 0 0 rotate 90 0 1 0 scale 3 3 1 square pop\n"
                                 "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop\n"
                                 "defaultMaterials diffuse 0 0 0 specular 0 0 0 reflectivity 0.9\n"
                                 "push translate 0 0 -1.2 scale 2 2 1 square pop");
  scene.settings.caustics = Caustics::off;
  const auto camera = test::over_seeds(scene, 64);
  scene.settings.caustics = Caustics::automatic;
  scene.settings.light_paths = 4.0;
  const auto both = test::over_seeds(scene, 64);
  CHECK(both.total == Approx(camera.total).epsilon(0.015));
}
