#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace abbe;

namespace {

/// A lens of the project 500 mm from the origin; a square film.
std::string camera_text(const std::string& lens) {
  return "eye 0 0 500 imageSize 32 32 filmHeight 6 fNumber 5.6 lensFile \"" ABBE_SOURCE_DIR
         "/scenes/lenses/" +
         lens + ".lens\" ";
}

const std::string kSinglet = camera_text("singlet_bk7_50");
const std::string kAchromat = camera_text("achromat_ac254_050_a");

/// A white card whose left half is black.
const std::string kEdge = "globalAmbient E 1 defaultMaterials ambient 1 1 1 diffuse 0 0 0 "
                          "translate 50 0 0 scale 50 50 1 square ";

/// How far x and z depart from y in the column, relative to white.
double colour(const Rendering& r, int x) {
  double red = 0.0, blue = 0.0;
  for (int y = 0; y < 32; ++y) {
    red += r.film.color(x, y).x - r.film.color(x, y).y;
    blue += r.film.color(x, y).z - r.film.color(x, y).y;
  }
  return (std::abs(red) + std::abs(blue)) / 32.0;
}

Rendering rendered(const std::string& text) {
  return test::render_scene(test::scene_from(text), false);
}

} // namespace

TEST_CASE("a uniform background through a real lens is as bright as it is") {
  for (const std::string integrator : {"whitted", "path"}) {
    const Rendering r = rendered(
        kSinglet + "samples 64 crop 14 14 18 18 background E 0.5 integrator " + integrator);
    double sum = 0.0;
    for (int y = 14; y < 18; ++y)
      for (int x = 14; x < 18; ++x)
        sum += r.film.color(x, y).y / 16.0;
    CHECK(sum == Approx(0.5).epsilon(0.01));
  }
}

TEST_CASE("a singlet fringes an edge with colour, an achromat does not") {
  // Pixels of 0.025 mm. In blue the singlet is some 0.8 mm out of focus: a disc of 0.14 mm.
  const Rendering singlet = rendered(kSinglet + "filmHeight 0.8 samples 64 " + kEdge);
  const Rendering achromat = rendered(kAchromat + "filmHeight 0.8 samples 64 " + kEdge);
  double most = 0.0, least = 0.0;
  for (int x = 10; x < 22; ++x) {
    most = std::max(most, colour(singlet, x));
    least = std::max(least, colour(achromat, x));
  }
  CHECK(most > 0.1);
  CHECK(least < 0.4 * most);
  // Blue is out of focus, and reaches into the black.
  double blue = 0.0, yellow = 0.0;
  for (int y = 0; y < 32; ++y) {
    blue += singlet.film.color(14, y).z;
    yellow += singlet.film.color(14, y).y;
  }
  CHECK(blue > 2.0 * yellow);
}

TEST_CASE("bands that share rays, and roulette, give the image of every band by itself") {
  const std::string text = kSinglet + "imageSize 16 16 filmHeight 0.8 samples 64 " + kEdge;
  const Rendering shared = rendered(text), exact = rendered(text + "exact on");
  CHECK(shared.rays.camera < exact.rays.camera / 5);
  for (int x = 0; x < 16; ++x) {
    Xyz a{}, b{};
    for (int y = 0; y < 16; ++y) {
      a += shared.film.color(x, y);
      b += exact.film.color(x, y);
    }
    CHECK(a.x / 16.0 == Approx(b.x / 16.0).margin(0.015));
    CHECK(a.y / 16.0 == Approx(b.y / 16.0).margin(0.015));
    CHECK(a.z / 16.0 == Approx(b.z / 16.0).margin(0.02));
  }
}

TEST_CASE("threads do not change an image through a lens") {
  const std::string text = kSinglet + "samples 5 " + kEdge;
  Scene scene = test::scene_from(text);
  scene.settings.threads = 1;
  const Rendering one = test::render_scene(scene, false);
  scene.settings.threads = 7;
  const Rendering seven = test::render_scene(scene, false);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      REQUIRE(one.film.color(x, y) == seven.film.color(x, y));
}
