#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

/// Luminance of the point (0, 0, 0) of a scene, seen from (3, 1, 2) by paths of one surface: light
/// comes straight from a light.
double seen(const std::string& text, int samples = 4096) {
  const Scene scene =
      test::scene_from("integrator path maxRecursionDepth 1 filter box\n"
                       "eye 3 1 2 lookAt 0 0 0 up 0 0 1 fieldOfView 0.0001 imageSize 1 1 samples " +
                       std::to_string(samples) + "\n" + text);
  return test::render_scene(scene, false).film.color(0, 0).y;
}

/// A floor z = 0 that sends back half of the light.
const std::string kFloor = "ambient 0 0 0 diffuse 0.5 0.5 0.5 push scale 9 9 9 square pop\n";
/// Shapes that follow shine with radiance 1 and reflect nothing.
const std::string kGlow = "diffuse 0 0 0 emissive E 1\n";
constexpr double kReflectance = 0.5;

/// Irradiance at the origin, with normal z, of a polygon of radiance 1 above the floor: Lambert's
/// sum over edges of the angle they fill times the part of their plane's normal along z, over 2.
template <std::size_t N>
double polygon_irradiance(const std::array<dvec3, N>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    const dvec3 a = glm::normalize(corners[i]), b = glm::normalize(corners[(i + 1) % N]);
    const dvec3 across = glm::cross(a, b);
    sum += std::atan2(glm::length(across), glm::dot(a, b)) * glm::normalize(across).z;
  }
  return std::abs(0.5 * sum);
}

} // namespace

TEST_CASE("a square light lights a floor by Lambert's polygon formula") {
  for (const dvec3 centre : {dvec3(0, 0, 2), dvec3(1.5, -1, 1.2), dvec3(0.3, 0.2, 0.8)}) {
    const std::array<dvec3, 4> corners{centre + dvec3(-0.5, -0.4, 0), centre + dvec3(0.5, -0.4, 0),
                                       centre + dvec3(0.5, 0.4, 0), centre + dvec3(-0.5, 0.4, 0)};
    const std::string place = "push translate " + std::to_string(centre.x) + " " +
                              std::to_string(centre.y) + " " + std::to_string(centre.z) +
                              " scale 0.5 0.4 -1 square pop";
    const double expected = kReflectance / kPi * polygon_irradiance(corners);
    CHECK(seen(kFloor + kGlow + "emissiveSides front " + place) == Approx(expected).epsilon(1e-3));
    CHECK(seen(kFloor + kGlow + place) == Approx(expected).epsilon(1e-3));
  }
}

// A ball of radiance L wholly above the horizon gives the irradiance pi L (R / d)^2 cos.
TEST_CASE("a ball light lights a floor by its closed form") {
  const auto lit = [](const std::string& ball, int samples = 4096) {
    return seen(kFloor + kGlow + "push " + ball + " sphere pop", samples);
  };
  CHECK(lit("translate 0 0 2 scale 0.5 0.5 0.5") == Approx(kReflectance / 16.0).epsilon(1e-3));
  CHECK(lit("translate 0 3 4 rotate 33 1 2 3 scale 2 2 2") ==
        Approx(kReflectance * 0.8 * 4.0 / 25.0).epsilon(1e-3));
  CHECK(lit("translate 0 0 10 scale 0.01 -0.01 0.01") == Approx(kReflectance * 1e-6).epsilon(1e-3));
  CHECK(lit("translate 0 0 1.25") == Approx(kReflectance / (1.25 * 1.25)).epsilon(1e-3));
}

// Of an ellipsoid the upper half may be cut away as well as the lower: the horizon of a place on
// its axis is a plane across the axis, a disc seen from the place.
TEST_CASE("an ellipsoid on the axis shines like the disc that its outline is") {
  // Half-axes 1, 1, 0.5, centre at height 2. The outline's plane is (0.5)^2 / 2 below the centre,
  // where the radius is sqrt(1 - (0.125 / 0.5)^2).
  const double height = 2.0 - 0.125, radius2 = 1.0 - 0.0625;
  const double expected = kReflectance * radius2 / (radius2 + height * height);
  CHECK(seen(kFloor + kGlow + "translate 0 0 2 scale 1 1 0.5 sphere", 16384) ==
        Approx(expected).epsilon(3e-3));
}

// The same solid once as a box, which is aimed at, and once as a polyhedron, which is met by
// chance alone: two unbiased estimates of one number.
TEST_CASE("light samples change the noise and not the mean") {
  const std::string turned = "translate 0.4 0.3 1.6 rotate 40 1 2 0 scale 0.7 0.5 0.6 ";
  const double aimed = seen(kFloor + kGlow + turned + "cube", 4096);
  const double by_chance = seen(kFloor + kGlow + turned +
                                    "polyhedron planes 6 1 0 0 1 -1 0 0 1 0 1 0 1 0 -1 0 1 "
                                    "0 0 1 1 0 0 -1 1",
                                65536);
  CHECK(aimed == Approx(by_chance).epsilon(5e-3));
}

TEST_CASE("a disc light on the axis lights a floor by r^2 / (r^2 + h^2)") {
  CHECK(seen(kFloor + kGlow + "translate 0 0 1.5 scale 0.7 0.7 1 disc") ==
        Approx(kReflectance * 0.49 / (0.49 + 2.25)).epsilon(1e-3));
}

TEST_CASE("many lights add up") {
  const std::string far_one = "push translate 0 3 4 scale 2 2 2 sphere pop\n";
  const std::string near_one = "push translate 0 0 1 scale 0.1 0.1 0.1 sphere pop\n";
  const std::string parallel = "light E 0 -1.7320508 1 0\n"; // at 60 degrees
  const double expected = kReflectance * (0.8 * 4.0 / 25.0 + 0.01 + 0.5);
  CHECK(seen(parallel + kFloor + kGlow + far_one + near_one, 16384) ==
        Approx(expected).epsilon(5e-3));
}
