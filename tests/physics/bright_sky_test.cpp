#include "spectral/illuminant.h"
#include "tests/catch.h"
#include "tests/seeds.h"

#include <cmath>
#include <string>
#include <vector>

using namespace abbe;

namespace {

/// A blue sky with a yellow patch that is 100 times as bright, high above.
Environment sky() {
  Environment e;
  e.width = 32;
  e.height = 16;
  e.light = *find_illuminant("D65");
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) {
      const bool sun = (y == 1 || y == 2) && x > 7 && x < 11;
      for (const float v : {sun ? 20.0f : 0.1f, sun ? 18.0f : 0.15f, sun ? 9.0f : 0.25f})
        e.rgb.push_back(v);
    }
  return e;
}

/// A ball of glass over a floor; the camera sees the floor below it.
Scene ball_under_sky() {
  Scene scene = test::scene_from(
      "integrator path eye 0 0.4 3 lookAt 0 -1 0 fieldOfView 22 imageSize 8 8 samples 64\n"
      "defaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
      "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
      "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop");
  scene.environment = sky();
  return scene;
}

} // namespace

TEST_CASE("a sky's light through glass is the same, however much of it goes by light paths") {
  Scene scene = ball_under_sky();
  scene.settings.caustics = Caustics::off;
  const auto camera = test::over_seeds(scene, 96);
  scene.settings.caustics = Caustics::automatic;
  scene.settings.samples_per_pixel = 16;
  scene.settings.light_paths = 8.0;
  for (const double from : {0.0, 8.0, 1e15}) {
    INFO(from);
    scene.settings.bright_sky = from;
    const auto both = test::over_seeds(scene, 48);
    CHECK(std::abs(total_z(camera, both)) < 4.0);
    CHECK(both.total == Approx(camera.total).epsilon(0.02));
    CHECK(mean_square_z(camera, both) < 1.6);
  }
}

// Seen itself, in mirrors and through glass that the camera looks at, the sky is whole.
TEST_CASE("what the camera sees of a bright sky by mirrors and glass stays in the picture") {
  const auto seen = [](const std::string& body, double from) {
    Scene scene =
        test::scene_from("integrator path eye 0 5 0 up 0 0 -1 lookAt 0 0 0 fieldOfView 20 "
                         "imageSize 8 8 samples 32 filter box\n" +
                         body);
    scene.environment = sky();
    scene.settings.bright_sky = from;
    return test::over_seeds(scene, 4).total;
  };
  for (const std::string body :
       {"reflectivity 1 fresnel off diffuse 0 0 0 sphere", "glass N-BK7 sphere"})
    CHECK(seen(body, 0.0) == Approx(seen(body, 1e15)).epsilon(0.01));
}
