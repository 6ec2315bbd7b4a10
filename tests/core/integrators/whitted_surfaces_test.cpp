// Films and coats as whitted shows them, against their closed forms at normal incidence.

#include "core/optics/diffuse_fresnel.h"
#include "core/optics/fresnel.h"
#include "spectral/metal.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

/// One narrow pixel that looks down at the origin.
Film look(const std::string& text) {
  const Scene scene =
      test::scene_from("fieldOfView 0.0001 imageSize 1 1 samples 1 jitter off eye 0 0 9 "
                       "lookAt 0 0 0 minThroughput 1e-9\n" +
                       text);
  return std::move(test::render_scene(scene, true).film);
}

double square(double x) {
  return x * x;
}

} // namespace

TEST_CASE("an anti-reflection coating reflects by its thickness in wavelengths") {
  // What goes into the glass ends at the next surface.
  // |r1 + r2 e^-2id|^2 / |1 + r1 r2 e^-2id|^2 with real r: cosines of the double phase suffice.
  const Film film = look("background E 1 defaultMaterials diffuse 0 0 0 ambient 0 0 0 "
                         "reflectivity 1 transparency 1 maxRecursionDepth 1 speedOfLight 1.5 "
                         "thinFilm 99.6 1.38 cube");
  const double r1 = (1.0 - 1.38) / 2.38, r2 = (1.38 - 1.5) / 2.88;
  for (int b = 0; b < 81; ++b) {
    const double phase = 4.0 * std::numbers::pi * 1.38 * 99.6 / (380.0 + 5.0 * b);
    const double both = 2.0 * r1 * r2 * std::cos(phase);
    CHECK(film.radiance(0, 0, b) ==
          Approx((r1 * r1 + r2 * r2 + both) / (1.0 + square(r1 * r2) + both)).epsilon(1e-4));
  }
  CHECK(film.radiance(0, 0, 34) < 0.4 * 0.04); // at 550 nm, against 4 % of the bare glass
}

TEST_CASE("films on metal and between media of one index leave no energy over") {
  const Film metal = look("background E 1 metal Al thinFilm 180 1.5 square");
  const Film bare = look("background E 1 metal Al square");
  double largest = 0.0;
  for (int b = 0; b < 81; ++b) {
    CHECK(metal.radiance(0, 0, b) < 1.0);
    largest = std::max(largest, std::abs(metal.radiance(0, 0, b) - bare.radiance(0, 0, b)));
  }
  CHECK(largest > 0.02);
  for (const std::string options : {"maxFan 81 jitter on", "exact on"}) {
    const Film bubble =
        look(options + " background E 1 reflectivity 1 transparency 1 diffuse 0 0 0 "
                       "ambient 0 0 0 speedOfLight 1 thinFilm 420 1.33 "
                       "maxRecursionDepth 1000 sphere");
    const Film lens = look(options + " background E 1 glass SF11 thinFilm 300 1.38 "
                                     "maxRecursionDepth 1000 sphere");
    for (int b = 0; b < 81; ++b) {
      CHECK(bubble.radiance(0, 0, b) == Approx(1.0).epsilon(1e-5));
      CHECK(lens.radiance(0, 0, b) == Approx(1.0).epsilon(1e-5));
    }
  }
}

TEST_CASE("a soap film's colours are those of its reflectance") {
  // One boundary between air and air; what passes it is not followed.
  const Film film = look("background E 1 reflectivity 1 transparency 1 diffuse 0 0 0 ambient 0 0 0 "
                         "maxRecursionDepth 1 speedOfLight 1 thinFilm 350 1.33 cube");
  const double r0 = square(0.33 / 2.33);
  for (int b = 0; b < 81; ++b) {
    const double sine = std::sin(2.0 * std::numbers::pi * 1.33 * 350.0 / (380.0 + 5.0 * b));
    const double f = 4.0 * r0 * sine * sine;
    CHECK(film.radiance(0, 0, b) == Approx(f / (square(1.0 - r0) + f)).epsilon(1e-4).margin(1e-7));
  }
}

TEST_CASE("a straight shadow ray through coated glass loses what the film reflects") {
  const std::string ground = "shadows attenuated eye 5 0 2 light E 0 0 10 1 ambient 0 0 0 "
                             "diffuse 1 1 1 square\n";
  const std::string cube = " translate 0 0 3 scale 0.5 0.5 0.5 cube";
  const Film open = look(ground);
  const Film film = look(ground + "cauchy 1.9 0 0 thinFilm 100 1.378404875 " + cube);
  // A quarter wave at 4 n d = 551.36 nm of index sqrt(1.9) returns nothing, from either side.
  CHECK(film.radiance(0, 0, 34) / open.radiance(0, 0, 34) == Approx(1.0).epsilon(1e-4));
  const Film bare = look(ground + "cauchy 1.9 0 0" + cube);
  CHECK(bare.radiance(0, 0, 34) / open.radiance(0, 0, 34) ==
        Approx(square(1.0 - square(0.9 / 2.9))).epsilon(1e-4));
}

TEST_CASE("coated colour: Fresnel's reflection above, the ground below") {
  const std::string plastic = " ambient 0 0 0 diffuse 0.5 0.5 0.5 coat 1.5 square";
  const Film sky = look("background E 1" + plastic);
  CHECK(sky.radiance(0, 0, 34) == Approx(0.04).epsilon(1e-4));
  // rho T(wo) T(wi) / (n^2 (1 - rho R)) cos i for whitted's light of strength 1 at 60 degrees.
  const Film lit = look("shadows none light E 1.7320508 0 1 0" + plastic);
  const double within = 1.0 - diffuse_transmittance(1.0 / 1.5);
  CHECK(lit.radiance(0, 0, 34) == Approx(0.5 * 0.96 * (1.0 - fresnel_reflectance(0.5, 1.5)) /
                                         (2.25 * (1.0 - 0.5 * within)) * 0.5)
                                      .epsilon(1e-4));
}
