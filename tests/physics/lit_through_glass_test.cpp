#include "tests/catch.h"
#include "tests/seeds.h"

#include <cmath>
#include <string>

using namespace abbe;

// Things within and behind glass that a large light lights through it: photons against camera paths
// alone, which find such a light by chance.

namespace {

const std::string kLamp = "defaultMaterials diffuse 0 0 0 specular 0 0 0 emissive E 3\n"
                          "emissiveSides front push translate 0 5 4 rotate 140 1 0 0\n"
                          "scale 3 3 1 square pop defaultMaterials\n";

/// The middle of a card in the middle of a block of glass.
std::string embedded(const std::string& absorption) {
  return "integrator path maxRecursionDepth 12 eye 0 0 6 lookAt 0 0 0 fieldOfView 12\n"
         "imageSize 4 4 samples 256 lightPaths 16 photonRadius 0.05\n" +
         kLamp + "glass SF11 " + absorption +
         " cube\n"
         "defaultMaterials diffuse 0.8 0.4 0.2 specular 0 0 0 scale 0.9 0.9 1 square";
}

} // namespace

TEST_CASE("a card within glass, clear or absorbing, is as bright by photons as by camera paths") {
  for (const std::string absorption :
       {"", "absorption 0.5", "internalTransmittance 0.2 0.6 0.9 1"}) {
    INFO(absorption);
    Scene scene = test::scene_from(embedded(absorption));
    scene.settings.caustics = Caustics::off;
    const auto camera = test::over_seeds(scene, 64);
    scene.settings.caustics = Caustics::automatic;
    scene.settings.samples_per_pixel = 64;
    const auto both = test::over_seeds(scene, 16);
    CHECK(std::abs(total_z(camera, both)) < 4.0);
    CHECK(both.total == Approx(camera.total).epsilon(0.02));
  }
}

TEST_CASE("a light behind a plate of glass counts once, whichever shadow rays are asked for") {
  // Shadow rays go straight through the plate and leave out what is reflected within it: (1 - R)^2
  // of the light for (1 - R) / (1 + R), 0.1 % less for this glass, and more at a slant.
  Scene scene = test::scene_from("integrator path maxRecursionDepth 12 caustics off\n"
                                 "eye 0 0.5 3 lookAt 0 -1 0 fieldOfView 20 imageSize 4 4\n"
                                 "samples 256 lightPaths 64\n"
                                 "defaultMaterials diffuse 0.1 0.1 0.1 specular 0 0 0\n"
                                 "push translate 0 -1 0 rotate -90 1 0 0 scale 9 9 1 square pop\n"
                                 "defaultMaterials diffuse 0 0 0 emissive E 3\n"
                                 "push translate 0 2.4 0 rotate 90 1 0 0 scale 2 2 1 square pop\n"
                                 "glass N-BK7 push translate 0 1.2 0 scale 4 0.005 4 cube pop");
  scene.settings.shadows = ShadowRule::opaque;
  const auto paths = test::over_seeds(scene, 64);
  scene.settings.shadows = ShadowRule::attenuated;
  const auto straight = test::over_seeds(scene, 16);
  scene.settings.shadows = ShadowRule::opaque;
  scene.settings.caustics = Caustics::automatic;
  scene.settings.samples_per_pixel = 64;
  const auto light_side = test::over_seeds(scene, 16);
  CHECK(straight.total == Approx(paths.total).epsilon(0.02));
  CHECK(light_side.total == Approx(paths.total).epsilon(0.02));
}
