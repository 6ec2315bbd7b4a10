#include "core/drops/drop_phase_function.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBand = 34; // 550 nm

/// The radiance of a narrow look along -z through the cube from -1 to 1, which drops fill.
double seen(const std::string& text, int samples = 1) {
  const Scene scene = test::scene_from(
      "eye 0 0 50 lookAt 0 0 0 fieldOfView 0.0001 imageSize 1 1 jitter off samples " +
      std::to_string(samples) + "\n" + text);
  const Rendering r = test::render_scene(scene, true);
  CHECK(r.film.refused().not_finite == 0);
  return r.film.radiance(0, 0, kBand);
}

const std::string kDrops = " drops 0.4 dropIndex 1.3333 dropSun 0 ";
const std::string kCube = kDrops + "cube ";

/// The phase function of kDrops.
double phase(double angle_deg) {
  static const DropPhaseFunction of_drops(ConstantIndex{1.3333}, {{550.0}}, 0.0);
  return static_cast<double>(of_drops.at(std::cos(angle_deg * kPi / 180.0))[0]);
}

} // namespace

// The light's value 1 is an irradiance of pi. Light from the side has the same distance, 1, to
// every place on the axis: L = integral from 0 to 2 of s exp(-s t) dt * p(90 deg) pi exp(-s).
TEST_CASE("drops lit from the side send what their depth and their phase function say") {
  const double s = 0.4;
  const double expected = (1.0 - std::exp(-2.0 * s)) * phase(90.0) * kPi * std::exp(-s);
  for (const std::string integrator : {"", "integrator path "}) {
    CHECK(seen(integrator + "light E 1 0 0 0" + kCube) == Approx(expected).epsilon(1e-5));
    CHECK(seen(integrator + "intensity 3 light E 0 -1 0 0" + kCube) ==
          Approx(3.0 * expected).epsilon(1e-5));
    // All that is behind the drops is weakened.
    CHECK(seen(integrator + "background E 0.7 light E 1 0 0 0" + kCube) ==
          Approx(expected + 0.7 * std::exp(-2.0 * s)).epsilon(1e-5));
  }
}

// Light from behind the camera goes as deep as the ray: L = integral of s exp(-2 s t) dt p pi.
TEST_CASE("where the depth of the light changes along the ray, places are drawn in proportion") {
  const double s = 0.4;
  CHECK(seen("light E 0.0001 0 1 0" + kCube, 4096) ==
        Approx(0.5 * (1.0 - std::exp(-4.0 * s)) * phase(180.0 - 0.0001 * 180.0 / kPi) * kPi)
            .epsilon(2e-3));
  // From ahead the whole length is 2 at any depth.
  CHECK(seen("light E 1 0 -1 0 " + kDrops + "push scale 9 9 1 cube pop") ==
        Approx(seen("light E 1 0 -1 0 " + kDrops + "push scale 900 9 1 cube pop")).epsilon(1e-6));
}

TEST_CASE("absorption between the drops takes its part") {
  const double s = 0.4, a = 0.3;
  const double expected =
      s / (s + a) * (1.0 - std::exp(-2.0 * (s + a))) * phase(90.0) * kPi * std::exp(-(s + a));
  CHECK(seen("light E 1 0 0 0" + kDrops + "absorption 0.3 cube", 4096) ==
        Approx(expected).epsilon(2e-3));
}

TEST_CASE("a light at a place far off lights as parallel light from a point does") {
  CHECK(seen("light E 1e6 0 0 1" + kCube) == Approx(seen("light E 1 0 0 0" + kCube)).epsilon(1e-4));
  CHECK(seen("falloff square intensity 4 light E 2 0 0 1" + kDrops +
                 "push scale 0.001 0.001 0.001 cube pop",
             16) == Approx(seen("light E 1 0 0 0 intensity 1" + kDrops +
                                    "push scale 0.001 0.001 0.001 cube pop",
                                16) /
                           kPi)
                        .epsilon(1e-2));
}

TEST_CASE("drops stand in the shadow of what is opaque, under either rule") {
  const std::string wall = "defaultMaterials push translate 3 0 0 cube pop ";
  for (const char* rule : {"shadows opaque ", "shadows attenuated "}) {
    CHECK(seen(rule + wall + "light E 1 0 0 0" + kCube) == 0.0);
    CHECK(seen(rule + wall + "light E -1 0 0 0" + kCube) ==
          Approx(seen("light E -1 0 0 0" + kCube)).epsilon(1e-6));
  }
  CHECK(seen("shadows none " + wall + "light E 1 0 0 0" + kCube) ==
        Approx(seen("light E 1 0 0 0" + kCube) * std::exp(0.4)).epsilon(1e-5));
}

TEST_CASE("the drops' shadow is what they take out of the light, under either rule") {
  const std::string square = "light E 0 0 1 0 eye 3 0 -3 lookAt 0 0 -4 "
                             "defaultMaterials ambient 0 0 0 diffuse 0.5 0.5 0.5 "
                             "push translate 0 0 -4 square pop";
  for (const char* rule : {"shadows opaque ", "shadows attenuated "})
    CHECK(seen(rule + square + kCube) == Approx(0.5 * std::exp(-2.0 * 0.4)).epsilon(1e-5));
  CHECK(seen("shadows none " + square + kCube) == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("to opaque shadow rays glass is opaque, with drops about as well") {
  CHECK(seen("shadows opaque light E 1 0 0 0 glass N-BK7 push translate 3 0 0 cube pop" + kCube) ==
        0.0);
}

TEST_CASE("the solid that drops fill is not seen itself") {
  const std::string thin = "background E 0.7 drops 1e-9 ";
  CHECK(seen(thin + "cube") == Approx(0.7).epsilon(1e-6));
  CHECK(seen(thin + "rotate 33 1 2 3 scale 1 2 1 sphere") == Approx(0.7).epsilon(1e-6));
  CHECK(seen(thin + "integrator path cube") == Approx(0.7).epsilon(1e-6));
}

// A ray passes boundaries between equal media without a stop, and the solids around a place are
// then others than where it began.
TEST_CASE("solids of the same drops that overlap or touch are as one") {
  const double one = seen("light E 1 0 0 0" + kDrops + "push scale 1 1 2 cube pop");
  CHECK(
      seen(
          "light E 1 0 0 0" + kDrops +
              "push translate 0 0 0.8 scale 1 1 1.2 cube pop translate 0 0 -0.8 scale 1 1 1.2 cube",
          64) == Approx(one).epsilon(1e-5));
  CHECK(seen("light E 1 0 0 0" + kDrops +
                 "push translate 0 0 1 cube pop push translate 0 0 -1 cube pop",
             64) == Approx(one).epsilon(1e-5));
  CHECK(seen("light E 1 0 0 0" + kDrops + "push scale 1 1 2 cube pop scale 0.5 0.5 0.5 cube", 64) ==
        Approx(one).epsilon(1e-5));
}

TEST_CASE("the camera may stand among the drops") {
  const double s = 0.4;
  CHECK(seen("light E 1 0 0 0 eye 0 0 0 lookAt 0 0 -1" + kCube) ==
        Approx((1.0 - std::exp(-s)) * phase(90.0) * kPi * std::exp(-s)).epsilon(1e-5));
}

TEST_CASE("drops behind glass are seen through it, and those behind an opaque surface not") {
  const std::string lamp = "light E 1 0 0 0 ";
  const double bare = seen(lamp + kCube);
  const double r = std::pow(0.5 / 2.5, 2); // of a face of index 1.5, head-on
  // Two faces, and what is thrown to and fro between them: (1 - r) / (1 + r).
  CHECK(seen(lamp +
             "exact on minThroughput 0 defaultMaterials ambient 0 0 0 diffuse 0 0 0 "
             "reflectivity 1 transparency 1 speedOfLight 1.5 "
             "push translate 0 0 8 scale 4 4 0.1 cube pop" +
             kCube) == Approx(bare * (1.0 - r) / (1.0 + r)).epsilon(1e-4));
  CHECK(seen(lamp +
             "defaultMaterials ambient 0 0 0 diffuse 0 0 0 "
             "push translate 0 0 8 cube pop" +
             kCube) == 0.0);
}

TEST_CASE("boundaries of drops count as no surface of a path") {
  for (const char* integrator : {"", "integrator path "})
    CHECK(seen(std::string(integrator) + "maxRecursionDepth 0 background E 0.7 drops 0.1 cube "
                                         "push translate 0 0 5 cube pop") ==
          Approx(0.7 * std::exp(-0.4)).epsilon(1e-6));
}

TEST_CASE("lights drawn one at a time light drops as all together do") {
  const std::string lamps = "light E 1 0 0 0 intensity 2 light E 0 1 0 0 light E 30 0 0 1 ";
  CHECK(seen("integrator path " + lamps + kCube, 4096) ==
        Approx(seen(lamps + kCube)).epsilon(2e-2));
}

// The square of 0.04 units^2 at a distance of 20 and of radiance 1 has an irradiance of 1e-4.
TEST_CASE("surfaces that glow light the drops of a random path") {
  const std::string square = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 emissive E 1 "
                             "push translate 20 0 0 scale 0.1 0.1 0.1 rotate 90 0 1 0 square pop ";
  const std::string drops = kDrops + "push scale 0.01 0.01 0.01 cube pop";
  const double depth = 0.4 * 0.02;
  CHECK(seen("integrator path " + square + drops, 64) ==
        Approx((1.0 - std::exp(-depth)) * phase(90.0) * 1e-4).epsilon(1e-2));
  CHECK(seen(square + drops) == 0.0); // the thesis's model has lights only
}

// Lights that glow are reached in two ways, aimed at and by chance, and each is weighed with where
// a surface last scattered the path; drops on the way must not be taken for that place.
TEST_CASE("drops on the way leave the weights of glowing lights as they are") {
  const std::string room =
      "integrator path eye 3 0 2 lookAt 0 0 0 defaultMaterials ambient 0 0 0 diffuse 0.6 0.6 0.6 "
      "square diffuse 0 0 0 emissive E 1 push translate 0 0 1 square pop "
      "defaultMaterials ";
  const double open = seen(room, 1024);
  CHECK(open > 0.1);
  CHECK(seen(room + "drops 1e-9 push translate 0 0 0.5 scale 2 2 0.4 cube pop", 1024) ==
        Approx(open).epsilon(1e-4));
}

// Bands part elsewhere where a boundary of drops is met first, so the noise is not the same.
TEST_CASE("light paths go through drops to glass, and from glass to the camera") {
  const auto room = [](const std::string& drops) {
    return "integrator path fieldOfView 12 eye 1 -3 3 lookAt 0 0 0 falloff square intensity 20 "
           "light E 0 0 5 1 defaultMaterials ambient 0 0 0 diffuse 0.6 0.6 0.6 "
           "push scale 4 4 1 square pop " +
           drops + "glass N-BK7 push translate 0 0 1 scale 0.6 0.6 0.6 sphere pop ";
  };
  const double open = seen(room(""), 8192);
  CHECK(open > 1.5 * seen(room("") + "caustics off shadows opaque", 1024));
  CHECK(seen(room("drops 1e-9 push translate 0 0 2 scale 2.5 2.5 1.9 cube pop "), 8192) ==
        Approx(open).epsilon(2e-2));
}
