// Panes of thin glass in images: what lies behind one is dimmed by what the pane lets through,
// however its light is found.

#include "core/integrators/light_paths.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/core/bsdfs/pane_series.h"
#include "tests/core/integrators/walk_scene.h"
#include "tests/seeds.h"

#include <numbers>

using namespace abbe;
using test::pane_series;

namespace {

constexpr double kPi = std::numbers::pi;

const std::string kPane = "push translate 0 1 0 rotate -90 1 0 0 scale 50 50 1 square pop ";
const std::string kFloor = "defaultMaterials diffuse 0.8 0.8 0.8 ambient 0 0 0 specular 0 0 0 "
                           "push rotate -90 1 0 0 scale 50 50 1 square pop ";
/// The middle of the floor, from below the pane.
const std::string kEye = "eye 0 0.5 0.4 lookAt 0 0 0 fieldOfView 2 imageSize 4 4 jitter off ";

Film film_of(const std::string& text) {
  return std::move(test::render_scene(test::scene_from(text), true).film);
}

double mean(const std::string& text) {
  const Film film = film_of(text);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < film.window().height(); ++y)
    for (int x = 0; x < film.window().width(); ++x)
      for (int b = 0; b < film.bands(); ++b, ++count)
        sum += film.radiance(x, y, b);
  CHECK(film.refused().not_finite == 0);
  return sum / count;
}

const std::string kPanes = "thinGlass 4 1.5 push rotate 30 0 1 0 scale 2 2 1 square pop "
                           "push translate 0 0 -1 rotate 50 1 0 0 scale 2 2 1 disc pop "
                           "thinGlass 1 SF11 push translate 0 0 -3 scale 9 9 1 square pop ";
const std::string kFurnace = "background E 1 eye 0.3 0.2 5 lookAt 0 0 0 fieldOfView 28 "
                             "imageSize 8 8 maxRecursionDepth 30 ";

} // namespace

TEST_CASE("clear panes are invisible in a white furnace") {
  const Film film = film_of(kFurnace + "minThroughput 1e-9 exact on samples 1 " + kPanes);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (const int b : {0, 40, 80})
        CHECK(film.radiance(x, y, b) == Approx(1.0).epsilon(1e-5));
  CHECK(mean("integrator path samples 256 caustics off " + kFurnace + kPanes) ==
        Approx(1.0).epsilon(0.01));
}

// The pane lies in the plane of a face and reaches beyond it. It was seen in place of the face
// before, and light passed into the glass unbent: 2.25 came out in place of 1.
TEST_CASE("a pane on a face of glass, or of a wall, gives way to it") {
  const std::string glass = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 glass N-BK7 ";
  const std::string pane = "thinGlass 3 2 push translate 0 0 1 scale 2 2 1 square pop "
                           "push translate 0 0 -1 scale 1 1 1 disc pop ";
  for (const std::string& order : {glass + "cube " + pane, pane + glass + "cube "}) {
    const Film film = film_of(kFurnace + "minThroughput 1e-9 exact on samples 1 " + order);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        for (const int b : {0, 40, 80})
          CHECK(film.radiance(x, y, b) == Approx(1.0).epsilon(1e-4));
  }
  // A black wall stays black through its pane, and lets nothing shine in from behind.
  const std::string wall = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 specular 0 0 0 "
                           "push translate 0 0 1 scale 9 9 1 square pop ";
  CHECK(mean(kFurnace + "samples 1 " + wall + pane) == 0.0);
}

TEST_CASE(
    "a light behind a pane lights by what the pane lets through, whatever stops shadow rays") {
  const Glass& bk7 = *find_glass("N-BK7");
  for (const char* rules :
       {"integrator whitted shadows attenuated ", "integrator whitted shadows opaque ",
        "integrator path caustics off shadows opaque ",
        "integrator path caustics off shadows attenuated "}) {
    CAPTURE(rules);
    // One bounce, so that what the floor sends to the pane does not come back.
    const std::string lit =
        std::string(rules) + kEye + "maxRecursionDepth 1 samples 1 light E 0 1 1 0 ";
    const Film bare = film_of(lit + kFloor);
    const Film behind = film_of(lit + "thinGlass 3 N-BK7 absorption 0.1 " + kPane + kFloor);
    for (const int b : {0, 40, 80}) {
      const double n = refractive_index(bk7.dispersion, 380.0 + 5.0 * b);
      const double expected = pane_series(kPi / 4.0, 1.0, n, 0.3).transmitted;
      CHECK(behind.radiance(2, 2, b) / bare.radiance(2, 2, b) == Approx(expected).epsilon(1e-5));
    }
  }
}

// A square light of half-width 2 over the floor, at height 2, and one bounce: the light is found by
// light samples and by chance, and neither counts the pane as a surface.
TEST_CASE("a large light behind a pane is weighed as if the pane were not there") {
  double expected = 0.0;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double x = -2.0 + 4.0 * (i + 0.5) / kSteps, z = -2.0 + 4.0 * (j + 0.5) / kSteps;
      const double distance2 = x * x + z * z + 4.0, cosine = 2.0 / std::sqrt(distance2);
      expected += pane_series(std::acos(cosine), 1.0, 1.5, 0.0).transmitted * cosine * cosine /
                  distance2 * 16.0 / (kSteps * kSteps);
    }
  const std::string scene =
      "integrator path caustics off maxRecursionDepth 1 bands 9 samples 4096 " + kEye +
      "defaultMaterials emissive E 1 diffuse 0 0 0 ambient 0 0 0 "
      "push translate 0 2 0 rotate 90 1 0 0 scale 2 2 1 square pop thinGlass 3 1.5 " +
      kPane + kFloor;
  CHECK(mean(scene) == Approx(0.8 / kPi * expected).epsilon(0.01));
}

// The floor and the pane see nothing but each other and, through the pane, the sky: with the
// pane's mean transmittance T the floor shows rho T / (1 - rho (1 - T)).
TEST_CASE("a floor below a pane lies in the sky's light") {
  double through = 0.0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double mu = (i + 0.5) / kSteps;
    through += 2.0 * mu * pane_series(std::acos(mu), 1.0, 1.5, 0.0).transmitted / kSteps;
  }
  const std::string scene = "integrator path caustics off maxRecursionDepth 40 bands 9 "
                            "samples 2048 background E 1 " +
                            kEye + "thinGlass 3 1.5 push translate 0 1 0 rotate -90 1 0 0 plane " +
                            "pop defaultMaterials diffuse 0.8 0.8 0.8 ambient 0 0 0 "
                            "specular 0 0 0 rotate -90 1 0 0 plane ";
  CHECK(mean(scene) == Approx(0.8 * through / (1.0 - 0.8 * (1.0 - through))).epsilon(0.01));
}

namespace {

/// Follows light paths from a place, and says what flux of a band they leave on surfaces.
double photon_flux(const std::string& text, const dvec3& place, const dvec3& direction) {
  test::WalkScene s("integrator path light E 0 0 50 1 " + text);
  const Emission emission;
  Film film({0, 0, 1, 1}, 1.0, 0);
  LightPaths paths(s.plan, s.world, emission, nullptr, film);
  PhotonBatch batch;
  constexpr std::uint32_t kPaths = 4096;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    EmittedRay ray;
    ray.state = s.bundle_from(place, direction).state;
    ray.source = s.plan.light_source(0);
    ray.flux = 1.0;
    paths.trace(ray, Sampler(0, 0, i, 7), 1.0, &batch, 1.0 / kPaths, s.counts);
  }
  double flux = 0.0;
  for (const Photon& photon : batch.photons)
    for (int b = 0; b < photon.bands.size() && !photon.beyond_limit; ++b)
      flux += static_cast<double>(batch.flux[photon.flux + static_cast<std::size_t>(b)]) / 81.0;
  return flux;
}

const std::string kMirror = "reflectivity 0.5 fresnel off diffuse 0 0 0 ambient 0 0 0 "
                            "push scale 9 9 1 square pop ";
const std::string kThin = "thinGlass 3 1.5 push translate 0 0 0.75 scale 9 9 1 square pop ";
const std::string kWall = "defaultMaterials push translate 0 0 1 scale 9 9 1 square pop ";

} // namespace

TEST_CASE("photons go through a pane; light that meets nothing but panes is no photon") {
  const double through = pane_series(kPi / 4.0, 1.0, 1.5, 0.0).transmitted;
  CHECK(photon_flux(kMirror + kWall, {-0.5, 0, 0.5}, {1, 0, -1}) == Approx(0.5));
  // What the pane returns goes by the mirror once more, and so on: T / 2 / (1 - R / 2).
  CHECK(photon_flux(kMirror + kThin + kWall, {-0.5, 0, 0.5}, {1, 0, -1}) ==
        Approx(0.5 * through / (1.0 - 0.5 * (1.0 - through))).epsilon(0.02));
  CHECK(photon_flux(kThin + kWall, {0, 0, 0.5}, {0, 0.1, 1}) == 0.0);
}

// Two panes choose by numbers of their own: with the first's the second would let all through. What
// a pane returns is a second surface and ends there.
TEST_CASE("panes in a row dim light one after the other") {
  const double through = pane_series(kPi / 4.0, 1.0, 1.5, 0.0).transmitted;
  const std::string second = "push translate 0 0 0.85 scale 9 9 1 square pop ";
  CHECK(photon_flux("maxRecursionDepth 2 " + kMirror + kThin + second + kWall, {-0.5, 0, 0.5},
                    {1, 0, -1}) == Approx(0.5 * through * through).epsilon(0.02));
}

// A spot of light on a ceiling, by way of a mirror, so that all of it is splats.
TEST_CASE("splats are seen through a pane") {
  const std::string scene =
      "integrator path maxRecursionDepth 6 samples 16 lightPaths 64 imageSize 4 4 "
      "eye 2 0.5 1.5 lookAt 2 2 0 fieldOfView 4 falloff square "
      "spotlight E -1 1 0 1 1 -1 0 8 "
      "reflectivity 1 fresnel off diffuse 0 0 0 ambient 0 0 0 specular 0 0 0 "
      "push rotate -90 1 0 0 scale 5 5 1 square pop "
      "defaultMaterials diffuse 0.5 0.5 0.5 ambient 0 0 0 specular 0 0 0 "
      "push translate 2 2 0 rotate 90 1 0 0 scale 5 5 1 square pop ";
  const std::string pane = "thinGlass 3 1.5 push translate 2 0.64 1.36 rotate 90 1 0 0 "
                           "scale 0.05 0.05 1 square pop ";
  const auto bare = test::over_seeds(test::scene_from(scene), 16);
  const auto behind = test::over_seeds(test::scene_from(scene + pane), 16);
  REQUIRE(bare.total > 0.0);
  CHECK(behind.total / bare.total ==
        Approx(pane_series(kPi / 4.0, 1.0, 1.5, 0.0).transmitted).epsilon(0.02));
}
