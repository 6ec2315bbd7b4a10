#include "spectral/observer.h"
#include "spectral/radiator.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Luminance in the middle of the image; the camera looks down from (0, 0, 5) at the origin.
double seen(const std::string& text, int samples = 1024) {
  const Scene scene = test::scene_from("filter box fieldOfView 0.0001 imageSize 1 1 samples " +
                                       std::to_string(samples) + "\n" + text);
  return test::render_scene(scene, false).film.color(0, 0).y;
}

const std::string kWhite = "ambient 0 0 0 diffuse 1 1 1 square\n";
const std::string kPaths = "integrator path maxRecursionDepth 1\n";

} // namespace

// The disc's radiance times its projected solid angle pi sin^2 r cos is the irradiance of parallel
// light, whatever r, as long as all of the disc is above the horizon.
TEST_CASE("a sun lights a surface as parallel light does, however wide it is") {
  for (const std::string radius : {"0.2665", "5", "30", "0.01"})
    for (const std::string direction : {"0 0 1", "0.3 0.4 1", "0 -2 3"}) {
      CAPTURE(radius, direction);
      const double parallel = seen(kPaths + kWhite + "light E " + direction + " 0");
      CHECK(seen(kPaths + kWhite + "sunRadius " + radius + " sun " + direction + " E", 4096) ==
            Approx(parallel).epsilon(1e-3));
      CHECK(seen("integrator whitted " + kWhite + "sunRadius " + radius + " sun " + direction +
                 " E") == Approx(parallel).epsilon(1e-5));
    }
}

TEST_CASE("a sun facing a white surface gives it the value as radiance") {
  CHECK(seen(kPaths + kWhite + "intensity 3 sun 0 0 1 E") == Approx(3.0).epsilon(1e-3));
  CHECK(seen(kPaths + kWhite + "sun 0 0 1") == Approx(1.0).epsilon(1e-3)); // 5778 K has Y = 1
}

TEST_CASE("a sun is seen as a disc of radiance value over sin^2, and beyond its edge not") {
  const double sine = std::sin(0.2665 * kDegree);
  for (const std::string integrator : {"integrator path\n", "integrator whitted\n"}) {
    CHECK(seen(integrator + "sun 0 0 -1 E", 1) == Approx(1.0 / (sine * sine)).epsilon(1e-5));
    const auto off = [](double angle_deg) {
      return "sun " + std::to_string(std::sin(angle_deg * kDegree)) + " 0 " +
             std::to_string(-std::cos(angle_deg * kDegree)) + " E";
    };
    CHECK(seen(integrator + off(0.26), 1) > 0.0);
    CHECK(seen(integrator + off(0.275), 1) == 0.0);
  }
}

// A mirror at 45 degrees sends the view from -z to +x.
TEST_CASE("mirrors and glass show the sun's disc") {
  const double disc = 1.0 / std::pow(std::sin(0.2665 * kDegree), 2);
  const std::string mirror =
      "ambient 0 0 0 diffuse 0 0 0 reflectivity 0.5 rotate 45 0 1 0 square\n";
  const std::string pane = "ambient 0 0 0 diffuse 0 0 0 fresnel off transparency 1 "
                           "speedOfLight 1.5 scale 1 1 0.1 cube\n";
  for (const std::string integrator : {"integrator path\n", "integrator whitted\n"}) {
    CHECK(seen(integrator + "sun 1 0 0 E " + mirror, 1) == Approx(0.5 * disc).epsilon(1e-5));
    CHECK(seen(integrator + "sun 0 0 -1 E " + pane, 1) == Approx(disc).epsilon(1e-5));
  }
}

// Behind the edge of a wide screen half of the disc is hidden.
TEST_CASE("a sun makes soft shadows with paths, and hard ones with whitted") {
  const std::string edge = "sunRadius 4 sun 0 0 1 E push translate 5 0 1 scale 5 5 1 "
                           "ambient 0 0 0 diffuse 0 0 0 square pop eye 0 0 0.5 ";
  CHECK(seen(kPaths + kWhite + edge, 4096) == Approx(0.5).epsilon(5e-3));
  const std::string moved = "sunRadius 4 sun 0 0 1 E push translate 5.001 0 1 scale 5 5 1 "
                            "ambient 0 0 0 diffuse 0 0 0 square pop eye 0 0 0.5 ";
  CHECK(seen("integrator whitted " + kWhite + moved) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("an image that shows the sun does not overflow") {
  const Rendering r = test::render_scene(
      test::scene_from("imageSize 2 2 samples 4096 fieldOfView 0.01 intensity 1000 sun 0 0 -1 E"),
      false);
  CHECK(r.film.refused().overflow == 0);
  CHECK(r.film.color(1, 1).y == Approx(1000.0 / std::pow(std::sin(0.2665 * kDegree), 2)));
}
