#include "io/console/progress.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <string>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("the summary tells what light paths did where there are any") {
  const std::string ball = "imageSize 16 12 samples 2 lightPaths 2 eye 0 2 4 lookAt 0 -1 0\n"
                           "falloff square light E 0 3 0 1 glass N-BK7 sphere\n"
                           "defaultMaterials diffuse 0.5 0.5 0.5\n"
                           "push translate 0 -1 0 rotate -90 1 0 0 scale 9 9 1 square pop\n";
  const Rendering without = test::render_scene(test::scene_from(ball), false);
  CHECK_THAT(summary(without), !ContainsSubstring("light paths"));

  const Rendering with = test::render_scene(test::scene_from("integrator path " + ball), false);
  CHECK(with.rays.light == 16 * 12 * 2 * 2);
  // What goes through the ball reaches the floor, and some of it places that the camera sees.
  CHECK(with.rays.photons > with.rays.light / 2);
  CHECK(with.rays.splats > 0);
  CHECK(with.light_seconds > 0.0);
  CHECK(with.light_seconds <= with.seconds);
  CHECK_THAT(
      summary(with),
      ContainsSubstring("light paths: 768 in ") &&
          ContainsSubstring(" million/s; " + std::to_string(with.rays.splats) + " splats, ") &&
          ContainsSubstring(std::to_string(with.rays.photons) + " photons\n"));
}
