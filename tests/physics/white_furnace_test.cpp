#include "tests/catch.h"
#include "tests/render_text.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace abbe;

namespace {

/// Largest departure from 1 of any band of any pixel when the solid stands in light of radiance 1
/// from all sides. A lossless solid is then invisible: each pixel's path tree reaches the same
/// radiance at every leaf, R + T = 1 at every node, and the factors n^2 cancel where the ray
/// leaves.
double furnace_error(const std::string& solid, const std::string& options) {
  const Scene scene = test::scene_from("background E 1\n"
                                       "eye 1.7 1.1 5  lookAt 0 0 0  fieldOfView 28\n"
                                       "imageSize 12 12  samples 1  maxRecursionDepth 100000\n"
                                       "minThroughput 1e-9\n" +
                                       options + "\n" + solid);
  const Rendering r = test::render_scene(scene, true);
  double worst = 0.0;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x)
      for (int b = 0; b < r.film.bands(); ++b)
        worst = std::max(worst, std::abs(r.film.radiance(x, y, b) - 1.0));
  CHECK(r.film.refused().not_finite == 0);
  CHECK(r.film.refused().negative == 0);
  CHECK(r.film.alpha(6, 6) == 1.0); // the solid is there
  return worst;
}

} // namespace

TEST_CASE("lossless glass solids are invisible in a white furnace, band by band") {
  for (const char* solid :
       {"glass SF11 sphere", "glass N-BK7 cube", "glass SF11 rotate 25 0 1 0 prism",
        "glass N-BK7 scale 1 1 0.5 sphere",
        "glass F2 lens push translate 0 0 0.6 sphere pop push translate 0 0 -0.6 sphere pop"}) {
    INFO(solid);
    CHECK(furnace_error(solid, "exact on") < 1e-5);
    CHECK(furnace_error(solid, "maxFan 81") < 1e-5); // tolerance, but no roulette
  }
}

// Light can stay for thousands of reflections between a ball and a cube inside it. Branches that
// carry less than 1e-9 go on at random, so that nothing is missing in the end.
TEST_CASE("solids within solids are invisible too") {
  CHECK(furnace_error("glass SF11 sphere priority 1 glass N-BK7 push scale 0.5 0.5 0.5 cube pop",
                      "bands 3 exact on") < 5e-5);
}

// The sum of the parts is 1 at every wavelength, though shapes begin with a diffuse part of 0.8. A
// path goes one way at each surface, by a chance for all bands at once, so it is right in the mean.
TEST_CASE("a body that is made transparent by hand is invisible too") {
  for (const std::string material :
       {"speedOfLight 1.5 reflectivity 1 transparency 1 ",
        "thinFilm 400 1.33 speedOfLight 1 transparency 1 reflectivity 1 ", // a soap bubble
        "fresnel off transparency 1 reflectivity 1 "}) {                   // half of each
    INFO(material);
    CHECK(furnace_error(material + "sphere", "bands 3") < 1e-4);
    const Rendering r = test::render_scene(
        test::scene_from("background E 1 eye 1.7 1.1 5 lookAt 0 0 0 fieldOfView 20 imageSize 12 12 "
                         "samples 256 bands 3 maxRecursionDepth 1000 integrator path " +
                         material + "sphere"),
        true);
    double sum = 0.0;
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x)
        for (int b = 0; b < 3; ++b)
          sum += r.film.radiance(x, y, b) / (12 * 12 * 3);
    CHECK(sum == Approx(1.0).epsilon(0.005)); // the default diffuse part would add a tenth and more
  }
}

TEST_CASE("a library's colours above 1 count as 1") {
  const std::string library = std::filesystem::temp_directory_path() /
                              ("abbe_furnace." + std::to_string(::getpid()) + ".mtl");
  std::string colours;
  for (int i = 0; i < 81; ++i)
    colours += " 100";
  std::ofstream(library) << "def bright { reflectivity 1 freqBreakdown 81" << colours << " }";
  CHECK(furnace_error("materials \"" + library + "\" useMaterial bright sphere",
                      "bands 3 integrator path") < 1e-4);
  std::filesystem::remove(library);
}
