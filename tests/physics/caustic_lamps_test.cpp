#include "core/lights/emission.h"
#include "core/planning/make_plan.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/seeds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace abbe;

// Lights as beginnings of light paths: against camera paths alone, and against closed forms.

namespace {

/// A ball of glass over a floor; the camera sees the floor below it and neither ball nor light.
std::string floor_with(const std::string& lamp) {
  return "integrator path maxRecursionDepth 12 eye 0 0.4 3 lookAt 0 -1 0 fieldOfView 22\n"
         "imageSize 8 8 samples 64\n" +
         lamp +
         "\ndefaultMaterials diffuse 0.7 0.7 0.7 specular 0 0 0\n"
         "push translate 0 -1 0 rotate -90 1 0 0 scale 3 3 1 square pop\n"
         "glass SF11 push translate 0 0.3 0 scale 0.6 0.6 0.6 sphere pop";
}

const std::string kGlow = "defaultMaterials diffuse 0 0 0 specular 0 0 0 emissive E 3 ";

struct Case {
  const char* name;
  std::string lamp;
};

const std::vector<Case>& lamps() {
  static const std::vector<Case> all = {
      {"sun", "sunRadius 8 sun 0.15 1 0"},
      {"box", kGlow + "push translate 0.3 2.4 0 rotate 30 1 1 0 scale 0.6 0.5 0.6 cube pop"},
      {"disc", kGlow + "push translate 0.3 2.4 0 rotate 90 1 0 0 scale 1 1 1 disc pop"},
      {"square that glows on both sides",
       kGlow + "push translate 0.2 2.4 0 rotate -80 1 0 0 scale 0.9 0.8 1 square pop"},
      {"square that glows in front", kGlow + "emissiveSides front push translate 0.2 2.4 0 rotate "
                                             "95 1 0 0 scale 0.9 0.8 1 square pop"},
      {"squeezed ball", kGlow + "push translate 0.3 2.4 0 scale 1 0.5 0.8 sphere pop"},
  };
  return all;
}

} // namespace

TEST_CASE("caustics of each kind of light are those of camera paths alone") {
  for (const Case& c : lamps()) {
    INFO(c.name);
    Scene scene = test::scene_from(floor_with(c.lamp));
    scene.settings.caustics = Caustics::off;
    const auto camera = test::over_seeds(scene, 96);
    scene.settings.caustics = Caustics::automatic;
    scene.settings.samples_per_pixel = 16;
    scene.settings.light_paths = 8.0;
    const auto both = test::over_seeds(scene, 48);
    CHECK(std::abs(total_z(camera, both)) < 4.0);
    CHECK(both.total == Approx(camera.total).epsilon(0.015));
  }
}

TEST_CASE("meshes and polyhedra that shine throw the caustics of the squares and boxes they are") {
  // The box's twelve triangles, counter-clockwise from outside, corner i at the signs of its bits.
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  const Mesh box_mesh(corners, {{0, 2, 3},
                                {0, 3, 1},
                                {4, 5, 7},
                                {4, 7, 6},
                                {0, 1, 5},
                                {0, 5, 4},
                                {2, 6, 7},
                                {2, 7, 3},
                                {0, 4, 6},
                                {0, 6, 2},
                                {1, 3, 7},
                                {1, 7, 5}});
  std::vector<HalfSpace> sides;
  for (int i = 0; i < 6; ++i) {
    dvec3 normal(0.0);
    normal[i / 2] = i % 2 == 0 ? -1.0 : 1.0;
    sides.push_back({normal, 1.0});
  }
  const Mesh square_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const std::string box =
      kGlow + "push translate 0.3 2.4 0 rotate 30 1 1 0 scale -0.6 0.5 0.6 cube pop";
  const std::string square = "push translate 0.2 2.4 0 rotate 95 1 0 0 scale 0.9 0.8 1 square pop";
  struct Twin {
    const char* name;
    std::string lamp;
    Shape shape;
  };
  const std::vector<Twin> twins = {
      {"box and mesh", box, box_mesh},
      {"box and polyhedron", box, ConvexPolyhedron(sides)},
      {"square and mesh, in front", kGlow + "emissiveSides front " + square, square_mesh}};
  for (const Twin& twin : twins) {
    INFO(twin.name);
    Scene scene = test::scene_from(floor_with(twin.lamp));
    scene.settings.samples_per_pixel = 128;
    scene.settings.light_paths = 8.0;
    const auto find_lamp = [&](PlacedShape& placed) {
      return std::holds_alternative<Box>(placed.shape) ||
             (std::holds_alternative<Square>(placed.shape) &&
              placed.material == scene.shapes.front().material);
    };
    const auto lamp = std::find_if(scene.shapes.begin(), scene.shapes.end(), find_lamp);
    REQUIRE(lamp != scene.shapes.end());
    const auto analytic = test::over_seeds(scene, 16);
    lamp->shape = twin.shape;
    CHECK(Emission(scene, make_plan(scene, scene.settings)).lights().size() == 1);
    const auto meshed = test::over_seeds(scene, 16);
    CHECK(std::abs(total_z(analytic, meshed)) < 4.0);
    CHECK(meshed.total == Approx(analytic.total).epsilon(0.01));
    CHECK(mean_square_z(analytic, meshed) < 1.5);
  }
}

TEST_CASE("parallel light and a tiny sun make the same caustic") {
  const auto total = [](const std::string& lamp) {
    Scene scene = test::scene_from(floor_with(lamp));
    scene.settings.samples_per_pixel = 16;
    scene.settings.light_paths = 16.0;
    return test::over_seeds(scene, 8);
  };
  const auto parallel = total("light E 0.15 1 0 0");
  const auto sun = total("sunRadius 0.01 sun 0.15 1 0 E");
  CHECK(std::abs(total_z(parallel, sun)) < 4.0);
  CHECK(sun.total == Approx(parallel.total).epsilon(0.01));
}

// Behind a clear plate at normal incidence 2n / (n^2 + 1) of the light arrives, all reflections
// within the plate included. The card below is nearly black, so nothing comes back from the plate.
TEST_CASE("a card under a plate of glass is as bright as Fresnel says, under each distant light") {
  const std::string plate =
      "integrator path maxRecursionDepth 40 eye 0 0 -1 lookAt 0 0 -3\n"
      "up 0 1 0 fieldOfView 80 imageSize 4 4 filter box samples 16 lightPaths 800\n"
      "jitter off glass SF11 push scale 2 2 0.1 cube pop\n"
      "defaultMaterials diffuse 0.01 0.01 0.01\n"
      "push translate 0 0 -3 scale 2 2 1 square pop ";
  const auto seen = [&](const std::string& lamp) {
    const Scene scene = test::scene_from(plate + lamp);
    const Rendering r = test::render_scene(scene, true);
    double sum = 0.0;
    for (int b = 0; b < 81; ++b) {
      const double n = refractive_index(find_glass("SF11")->dispersion, 380.0 + 5.0 * b);
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
          sum += r.film.radiance(x, y, b) / (2.0 * n / (n * n + 1.0)) / (81.0 * 16.0) / 0.01;
    }
    return sum;
  };
  CHECK(seen("light E 0 0 1 0") == Approx(1.0).epsilon(0.01));
  CHECK(seen("sunRadius 0.1 sun 0 0 1 E") == Approx(1.0).epsilon(0.01));
  // A far point: its value is intensity, so the irradiance is value / distance^2, less the shift
  // of the plate of 0.1 / 1000.
  CHECK(seen("falloff square light E 0 0 997 1") * 1e6 * std::numbers::pi ==
        Approx(1.0).epsilon(0.01));
}

// A card over a mirror without end, far from the origin, seen from below: light of irradiance pi
// times the value, that falls at an angle, reaches its lower side from a mirror that keeps half
// as half of the cosine. The card's shadow falls beside where that light comes from.
TEST_CASE("a mirror without end lights a card above it, wherever the scene stands") {
  for (const dvec3 place : {dvec3(0.0), dvec3(300.0, -70.0, 50.0), dvec3(0.0, 0.0, 2000.0)})
    for (const double height : {4.0, 40.0}) {
      for (const std::string lamp : {"light E 1 1 0 0", "sunRadius 0.05 sun 1 1 0 E"}) {
        const auto at = [&](const dvec3& p) {
          const dvec3 q = place + p;
          std::string text;
          for (const double x : {q.x, q.y, q.z})
            text.append(std::to_string(x)).append(" ");
          return text;
        };
        const Scene scene = test::scene_from(
            "integrator path imageSize 2 2 samples 64 lightPaths 256 fieldOfView 100 filter box\n"
            "up 0 0 1 eye " +
            at({0, -0.3, 0}) + "lookAt " + at({0, 1, 0}) + lamp +
            "\ndefaultMaterials diffuse 0.8 0.8 0.8\n"
            "push translate " +
            at({0, 0, 0}) +
            "rotate 90 1 0 0 square pop\n"
            "diffuse 0 0 0 reflectivity 0.5 fresnel off\n"
            "push translate " +
            at({0, -height, 0}) + "rotate -90 1 0 0 plane pop");
        CAPTURE(place.x, place.z, height, lamp);
        const auto seen = test::over_seeds(scene, 4);
        CHECK(seen.total == Approx(0.5 * 0.8 * std::sqrt(0.5)).epsilon(0.02));
      }
    }
}
