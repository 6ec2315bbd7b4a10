#include "tests/catch.h"
#include "tests/seeds.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

/// Parallel light of spectrum E goes along +x and meets a perfect mirror, which sends it straight
/// down: whatever lies below gets its light from photons alone, evenly. A surface that faces up has
/// the irradiance pi E, so it shows its diffuse reflectance times E. A thin lens, however thin,
/// cannot be connected to, so the camera looks photons up.
const std::string kLightFromAbove =
    "integrator path maxRecursionDepth 3 filter box caustics on\n"
    "aperture 1e-6 light E -1 0 0 0\n"
    "defaultMaterials diffuse 0 0 0 specular 0 0 0 reflectivity 1\n"
    "push translate 0 4 0 rotate -45 0 0 1 rotate 90 1 0 0 scale 2 2 1 square pop\n"
    "defaultMaterials diffuse 0.8 0.8 0.8 specular 0 0 0\n";

const std::string kFloor = "rotate -90 1 0 0 ";

test::SeedStatistics seen(const std::string& text, double photon_radius) {
  Scene scene = test::scene_from(kLightFromAbove + text);
  scene.settings.photon_radius = photon_radius;
  scene.settings.light_paths = 64.0;
  return test::over_seeds(scene, 12);
}

/// Y of the light's spectrum, from a picture in which it is the background.
double light_y() {
  Scene scene = test::scene_from("background E 1 imageSize 1 1 samples 1 eye 0 0 3 lookAt 0 0 0\n"
                                 "push translate 0 0 9 sphere pop");
  return test::over_seeds(scene, 2).total;
}

void check_mean(const test::SeedStatistics& picture, double expected) {
  CHECK(picture.total == Approx(expected).margin(4.0 * std::sqrt(picture.total_variance)));
  CHECK(std::sqrt(picture.total_variance) < 0.02 * expected);
}

} // namespace

TEST_CASE("two squares that touch show no seam in light that a mirror sends") {
  // The seam runs through the middle of the picture, within the radius of every pixel.
  const auto picture = seen("eye 0 1.5 0.2 lookAt 0 0 0 fieldOfView 4 imageSize 8 8 samples 16\n"
                            "push translate -1 0 0 " +
                                kFloor +
                                "square pop\n"
                                "push translate 1 0 0 rotate 180 1 0 0 " +
                                kFloor + "square pop",
                            0.1);
  check_mean(picture, 0.8 * light_y());
}

TEST_CASE("a ball shows the light that a mirror sends it, undimmed by its curvature") {
  // Light from above falls on a ball of radius R as the cosine of the angle from its top. A place
  // at angle a shows the mean over the cap within the photon radius r, cos a (1 - r^2 / 4 R^2),
  // since area on a ball is proportional to height. The camera sees |x|, |z| < s about the top,
  // where cos a has the mean 1 - s^2 / 3 R^2.
  constexpr double kR = 0.3, kRadius = 0.1;
  const double s = 1.2 * std::tan(std::numbers::pi / 180.0);
  const auto picture =
      seen("eye 0 1.5 0 lookAt 0 0.3 0 up 0 0 1 fieldOfView 2 imageSize 4 4 samples 16\n"
           "push scale 0.3 0.3 0.3 sphere pop\n" // and a card in the way of the light itself
           "push translate -1.5 0 0 rotate 90 0 1 0 square pop",
           kRadius);
  const double mean_cosine = 1.0 - s * s / (3.0 * kR * kR);
  const double blur = 1.0 - kRadius * kRadius / (4.0 * kR * kR);
  check_mean(picture, 0.8 * light_y() * mean_cosine * blur);
}

TEST_CASE("a sheet shields the floor below it from light by mirrors and glass") {
  for (const double gap : {0.02, 0.01, 0.001}) {
    const auto picture =
        seen(fmt::format("eye 0 {0} 1.5 lookAt 0 {1} 0 fieldOfView 1 imageSize 16 8 samples 16\n"
                         "push rotate -90 1 0 0 square pop\n"
                         "push translate 0 {2} 0 rotate -90 1 0 0 square pop",
                         0.5 * gap, 0.4 * gap, gap),
             0.03);
    CHECK(picture.total == 0.0);
  }
}
