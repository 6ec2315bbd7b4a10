#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

/// A white square lit head-on by a light above `blocker`, seen from aside, with strength 1.
Film under(const std::string& blocker, const std::string& lamp = "light E 0 0 10 1") {
  const Scene scene = test::scene_from(
      "fieldOfView 0.0001 imageSize 1 1 samples 1 jitter off eye 5 0 2 lookAt 0 0 0\n" + lamp +
      " defaultMaterials ambient 0 0 0 diffuse 1 1 1 square\n" + blocker);
  Rendering r = test::render_scene(scene, true);
  return std::move(r.film);
}

/// A cube with sides of length 1, 3 above the square.
const std::string kCube = " translate 0 0 3 scale 0.5 0.5 0.5 cube\n";
const std::string kOpaque = "defaultMaterials" + kCube;

double transmitted(double n) {
  const double r = (n - 1.0) / (n + 1.0);
  return 1.0 - r * r;
}

double lit(const std::string& blocker, const std::string& lamp = "light E 0 0 10 1") {
  return under(blocker, lamp).radiance(0, 0, 34) / under("").radiance(0, 0, 34);
}

} // namespace

TEST_CASE("an opaque solid between light and surface takes all light") {
  for (const char* rule : {"shadows opaque ", "shadows attenuated "})
    for (const char* lamp : {"light E 0 0 10 1", "light E 0 0 1 0"}) {
      CHECK(lit(rule + kOpaque, lamp) == 0.0);
      CHECK(lit(rule, lamp) == Approx(1.0).epsilon(1e-6));
    }
  CHECK(lit("shadows none " + kOpaque) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("what stands behind the light makes no shadow") {
  for (const char* rule : {"shadows opaque ", "shadows attenuated "})
    CHECK(lit(rule + kOpaque, "light E 0 0 2 1") == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("to opaque shadow rays glass is opaque") {
  CHECK(lit("shadows opaque glass N-BK7" + kCube) == 0.0);
}

// Two surfaces at normal incidence, each with 1 - R0; what runs to and fro between them is not a
// straight path and does not count.
TEST_CASE("glass weakens a straight shadow ray by the transmittance of its two faces, per band") {
  const Film film = under("shadows attenuated glass SF11" + kCube);
  const Film open = under("");
  for (int b = 0; b < 81; ++b) {
    const double t = transmitted(refractive_index(find_glass("SF11")->dispersion, 380.0 + 5.0 * b));
    CHECK(film.radiance(0, 0, b) / open.radiance(0, 0, b) == Approx(t * t).epsilon(1e-5));
  }
}

TEST_CASE("absorbing glass also weakens it by Beer and Lambert's law") {
  const std::string glass = "defaultMaterials reflectivity 1 transparency 0.9 speedOfLight 1.5 "
                            "absorption 0.7";
  const double faces = std::pow(0.9 * transmitted(1.5), 2.0);
  CHECK(lit(glass + kCube) == Approx(faces * std::exp(-0.7)).epsilon(1e-5));
  // A light inside the glass: one face, and the distance from its lower side at 2.5 up to the
  // light.
  CHECK(lit(glass + kCube, "light E 0 0 2.8 1") ==
        Approx(std::sqrt(faces) * std::exp(-0.7 * 0.3)).epsilon(1e-5));
}

TEST_CASE("without Fresnel the shadow ray keeps the constants alone") {
  CHECK(lit("defaultMaterials reflectivity 0.4 transparency 0.6 speedOfLight 1.5 fresnel off" +
            kCube) == Approx(0.36).epsilon(1e-5));
}

TEST_CASE("every solid on the way counts") {
  const double t = transmitted(1.5);
  const std::string glass = "defaultMaterials reflectivity 1 transparency 1 speedOfLight 1.5 ";
  CHECK(lit(glass + "push" + kCube + "pop push translate 0 0 2" + kCube + "pop") ==
        Approx(std::pow(t, 4.0)).epsilon(1e-5));
  CHECK(lit(glass + "push" + kCube + "pop push translate 0 0 2 " + kOpaque + "pop") == 0.0);
}

TEST_CASE("a convex solid does not shadow the side that faces the light, at any scale") {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    const std::string s = std::to_string(scale) + " ";
    const auto times = [&](double x) { return std::to_string(x * scale) + " "; };
    const Scene scene = test::scene_from(
        "imageSize 24 24 samples 4 fieldOfView 20 globalAmbient E 0 eye 0 0 " + times(5) +
        "lookAt 0 0 0 light E 0 0 1 0 defaultMaterials ambient 0 0 0 diffuse 1 1 1 scale " + s + s +
        s + "rotate 30 1 1 0 cube");
    const Rendering r = test::render_scene(scene, false);
    for (int y = 8; y < 16; ++y)
      for (int x = 8; x < 16; ++x)
        REQUIRE(r.film.color(x, y).y > 0.3);
  }
}
