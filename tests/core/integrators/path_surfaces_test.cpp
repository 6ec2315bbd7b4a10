// Rough, filmed and coated surfaces under the path tracer.

#include "core/optics/conductor_facets.h"
#include "core/optics/dielectric_facets.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>

using namespace abbe;

namespace {

/// The mean over the pixels and bands of an image.
double mean(const std::string& text, Caustics caustics = Caustics::off) {
  Scene scene = test::scene_from("integrator path imageSize 8 8 " + text);
  scene.settings.caustics = caustics;
  const Film film = std::move(test::render_scene(scene, true).film);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int b = 0; b < film.bands(); ++b, ++count)
        sum += film.radiance(x, y, b);
  CHECK(film.refused().not_finite == 0);
  CHECK(film.refused().negative == 0);
  return sum / count;
}

const std::string kFurnace = "background E 1 eye 1.7 1.1 5 lookAt 0 0 0 fieldOfView 14 "
                             "minThroughput 0 maxRecursionDepth 200 samples 2048 bands 9 ";

} // namespace

TEST_CASE("lossless rough solids are invisible in a white furnace") {
  for (const std::string solid :
       {"glass SF11 roughness 0.4 sphere", "glass N-BK7 roughness 1 sphere",
        "metal Al fresnel off roughness 0.8 sphere", "diffuse 1 1 1 ambient 0 0 0 coat 1.5 sphere",
        "diffuse 1 1 1 ambient 0 0 0 coat 1.5 roughness 0.5 sphere",
        "glass N-BK7 thinFilm 300 1.38 sphere"}) {
    INFO(solid);
    CHECK(mean(kFurnace + solid) == Approx(1.0).margin(0.005));
  }
}

TEST_CASE("a light in a rough mirror, against the integral over the light") {
  // A square light of half side 1, 2 above the mirror, beside the camera's straight look down.
  const double roughness = 0.6;
  const double seen = mean(
      "fieldOfView 0.01 samples 256 bands 1 eye 0 0 9 lookAt 0 0 0 diffuse 0 0 0 ambient 0 0 0 "
      "reflectivity 1 roughness 0.6 compensation off square "
      "push translate 2.5 0 2 rotate 180 1 0 0 defaultMaterials emissive E 1 ambient 0 0 0 "
      "diffuse 0 0 0 square pop");
  const double one = 1.0;
  SurfaceOptics optics;
  optics.n_before = &one;
  optics.opaque = true;
  double expected = 0.0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const dvec3 to_light{1.5 + 2.0 * (i + 0.5) / kSteps, -1.0 + 2.0 * (j + 0.5) / kSteps, 2.0};
      const double distance = glm::length(to_light);
      float f = 0.0f;
      (void)evaluate_conductor_facets({Ggx::from_roughness(roughness)}, optics, {0.0, 0.0, 1.0},
                                      to_light / distance, {0, 1}, &f);
      expected += static_cast<double>(f) * (2.0 / distance) / (distance * distance) * 4.0 /
                  (kSteps * kSteps);
    }
  CHECK(seen == Approx(expected).epsilon(0.02));
}

TEST_CASE("a light inside rough glass, against the integral over the light") {
  // A block far wider than the light; radiance falls by n^2 on its way out.
  const double roughness = 0.5;
  const double seen =
      mean("fieldOfView 0.01 samples 1024 bands 1 eye 0 0 9 lookAt 0 0 0 maxRecursionDepth 2 "
           "cauchy 1.5 0 0 roughness 0.5 compensation off "
           "push translate 0 0 -50 scale 500 500 50 cube pop "
           "push translate 0.5 0 -2 defaultMaterials emissive E 1 ambient 0 0 0 diffuse 0 0 0 "
           "square pop");
  const double one = 1.0, n = 1.5;
  SurfaceOptics optics;
  optics.n_before = &one;
  optics.n_after = &n;
  double expected = 0.0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const dvec3 to_light{-0.5 + 2.0 * (i + 0.5) / kSteps, -1.0 + 2.0 * (j + 0.5) / kSteps, -2.0};
      const double distance = glm::length(to_light);
      float f = 0.0f;
      (void)evaluate_dielectric_facets({Ggx::from_roughness(roughness)}, optics, {0.0, 0.0, 1.0},
                                       to_light / distance, {0, 1}, &f);
      expected += static_cast<double>(f) * (2.0 / distance) / (distance * distance) * 4.0 /
                  (kSteps * kSteps);
    }
  CHECK(seen == Approx(expected).epsilon(0.02));
}

TEST_CASE("caustics on or off, a rough lens throws as much light") {
  // A light behind smooth glass lights rough glass: with light-side passes its light comes from the
  // photon map, from both sides of the surface; without, from camera paths alone.
  const std::string scene =
      "samples 256 bands 1 fieldOfView 12 eye 0 0 9 lookAt 0 0 0 cauchy 1.5 0 0 push translate 0 0 "
      "-1 scale 2 2 0.5 cylinder pop roughness 0.5 push translate 0 0 0.2 scale 2 2 0.5 cylinder "
      "pop "
      "push translate 0 0 -4 defaultMaterials emissive E 1 ambient 0 0 0 diffuse 0 0 0 square pop ";
  CHECK(mean(scene, Caustics::on) == Approx(mean(scene)).epsilon(0.05));
}
