#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

constexpr double band_nm(int b) {
  return 380.0 + 5.0 * b;
}

/// Both integrators see radiance rho of a surface with reflectance rho here: Hill's light E head-on
/// for the one; for the other radiance 1 from everywhere, where Lambert's law by cosine-distributed
/// rays has no variance.
const std::string kWhitted = "light E 0 0 1 0\n";
const std::string kPath = "integrator path background E 1\n";

/// What one narrow pixel sees, straight down on x, y.
Rendering look(const std::string& text, double x, double y) {
  const std::string place = std::to_string(x) + " " + std::to_string(y) + " ";
  return test::render_scene(test::scene_from("eye " + place + "4 lookAt " + place +
                                             "0 fieldOfView 0.0001 imageSize 1 1 samples 1\n" +
                                             text),
                            true);
}

double seen(const std::string& text, double x, double y) {
  return look(text, x, y).film.radiance(0, 0, 34);
}

} // namespace

TEST_CASE("both integrators see a checker's fields where they are") {
  for (const std::string& setting : {kWhitted, kPath})
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 2; ++j) {
        const double value = seen(setting + "ambient 0 0 0 checker 4 2 0.75 0.75 0.75 0.25 0.25 "
                                            "0.25 square",
                                  -1 + (i + 0.5) * 0.5, -1 + (j + 0.5));
        CHECK(value == Approx((i + j) % 2 == 0 ? 0.75 : 0.25).epsilon(1e-5));
      }
}

TEST_CASE("a grid goes with its shape, and its fields have their spectrum") {
  const Scene scene = test::scene_from("diffuse 0.7 0.4 0.1 sphere");
  const Curve& field = scene.materials[0].diffuse;
  for (const std::string& setting : {kWhitted, kPath}) {
    // Scaled by 2: five fields 0.8 broad, their borders at -2, -1.2, -0.4, 0.4 ...
    const std::string text =
        setting + "ambient 0 0 0 grid 5 5 0.25 0 0 0 0.7 0.4 0.1 scale 2 2 1 square";
    const Rendering inside = look(text, 0.0, 0.8);
    for (int b = 0; b < 81; ++b)
      CHECK(inside.film.radiance(0, 0, b) == Approx(field.at(band_nm(b))).epsilon(1e-5));
    CHECK(seen(text, 0.45, 0.8) == 0.0);
    CHECK(seen(text, 0.0, -1.15) == 0.0);
    CHECK(seen(text, 0.51, 0.8) > 0.1);
  }
}

TEST_CASE("a checker's colours may be those of materials") {
  CHECK(seen(kPath + "diffuse 0.375 0.375 0.375 defMaterial dull diffuse 0.5 0.5 0.5 "
                     "checker 2 2 dull 0.125 0.125 0.125 square",
             0.5, 0.5) == Approx(0.375));
}

TEST_CASE("the last of diffuse and a texture counts") {
  const std::string checker = "checker 1 1 0.75 0.75 0.75 0 0 0 ", diffuse = "diffuse 0.5 0.5 0.5 ";
  CHECK(seen(kPath + checker + diffuse + "square", 0, 0.1) == Approx(0.5));
  CHECK(seen(kPath + diffuse + checker + "square", 0, 0.1) == Approx(0.75));
  CHECK(seen(kPath + checker + "defaultMaterials square", 0, 0.1) == Approx(0.8));
}

TEST_CASE("in any number of bands a checker shows the same brightness") {
  for (const char* bands : {"bands 1 ", "bands 9 ", "bands 405 "})
    CHECK(look(bands + kPath + "checker 2 2 0.75 0.75 0.75 0 0 0 square", 0.5, 0.5)
              .film.color(0, 0)
              .y == Approx(0.75).epsilon(1e-5));
}
