#include "core/optics/conductor_reflectance.h"

#include "core/optics/fresnel.h"
#include "spectral/metal.h"
#include "tests/catch.h"
#include "tests/render_text.h"
#include "tests/spectral/expected.h"

#include <cmath>
#include <complex>

using namespace abbe;

namespace {

/// Fresnel's equations as they stand, in complex numbers: an independent form of the reflectance.
double complex_reflectance(double cos_i, double n_before, double n, double k) {
  using Complex = std::complex<double>;
  const Complex eta = Complex(n, -k) / n_before;
  const Complex cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
  const Complex s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  const Complex p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  return 0.5 * (std::norm(s) + std::norm(p));
}

/// The radiance per band of a metal mirror under a white sky, seen at 60 degrees.
Film mirror_at_60_degrees(const std::string& material) {
  const Scene scene =
      test::scene_from("fieldOfView 0.0001 imageSize 1 1 samples 1 jitter off background E 1\n"
                       "eye 8.6602540378 0 5 lookAt 0 0 0 " +
                       material + " square");
  return std::move(test::render_scene(scene, true).film);
}

} // namespace

TEST_CASE("metals reflect at normal incidence as tabulated") {
  const test::Expected expected("conductor_r0.csv");
  CHECK(expected.row_count() == 50);
  for (int row = 0; row < expected.row_count(); ++row) {
    const Metal& metal = *find_metal(expected.text(row, "metal"));
    const double nm = expected.number(row, "nm");
    INFO(metal.name << ' ' << nm);
    const double n = metal.n.at(nm), k = metal.k.at(nm);
    CHECK(conductor_reflectance(1.0, 1.0, n, k) == Approx(expected.number(row, "R0")).margin(1e-6));
    CHECK(conductor_reflectance(1.0, 1.0, n, k) ==
          Approx(((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k)).epsilon(1e-12));
  }
}

TEST_CASE("the conductor's reflectance is Fresnel's with a complex index") {
  for (const Metal& metal : metal_catalogue())
    for (const double n_before : {1.0, 1.33, 1.8})
      for (double cos_i = 0.01; cos_i <= 1.0; cos_i += 0.03) {
        INFO(metal.name << ' ' << n_before << ' ' << cos_i);
        const double n = metal.n.at(550.0), k = metal.k.at(550.0);
        CHECK(conductor_reflectance(cos_i, n_before, n, k) ==
              Approx(complex_reflectance(cos_i, n_before, n, k)).epsilon(1e-11));
      }
}

TEST_CASE("without absorption a conductor reflects like glass, total reflection included") {
  for (const double n : {1.2, 1.5, 2.4})
    for (double cos_i = 0.05; cos_i <= 1.0; cos_i += 0.05) {
      CHECK(conductor_reflectance(cos_i, 1.0, n, 0.0) ==
            Approx(fresnel_reflectance(cos_i, n)).epsilon(1e-11));
      CHECK(conductor_reflectance(cos_i, n, 1.0, 0.0) ==
            Approx(fresnel_reflectance(cos_i, 1.0 / n)).epsilon(1e-9));
    }
}

TEST_CASE("every metal reflects all light at grazing incidence") {
  for (const Metal& metal : metal_catalogue()) {
    const double n = metal.n.at(600.0), k = metal.k.at(600.0);
    CHECK(conductor_reflectance(0.0, 1.0, n, k) == Approx(1.0).epsilon(1e-15));
    CHECK(conductor_reflectance(1e-6, 1.0, n, k) > 0.99997);
  }
}

TEST_CASE("a mirror of metal shows the sky times its reflectance, per band and angle") {
  const Film film = mirror_at_60_degrees("metal Au");
  const Film half = mirror_at_60_degrees("metal Au reflectivity 0.5");
  const Film without = mirror_at_60_degrees("metal Au fresnel off");
  const Metal& gold = *find_metal("Au");
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const double expected = complex_reflectance(0.5, 1.0, gold.n.at(nm), gold.k.at(nm));
    CHECK(film.radiance(0, 0, b) == Approx(expected).epsilon(1e-5));
    CHECK(half.radiance(0, 0, b) == Approx(0.5 * expected).epsilon(1e-5));
    CHECK(without.radiance(0, 0, b) == Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("metal inside glass reflects by the index of the glass") {
  // Light goes straight down into a block of constant index and back up from silver at its bottom,
  // which gives T^2 R / (1 - R (1 - T)). The sky's reflection at the top adds 1 - T.
  const Scene scene =
      test::scene_from("fieldOfView 0.0001 imageSize 1 1 samples 1 jitter off exact on background "
                       "E 1 minThroughput 0\n"
                       "maxRecursionDepth 60 eye 0 0 9 lookAt 0 0 0 cauchy 1.6 0 0\n"
                       "push scale 1 1 1 cube pop metal Ag push scale 0.5 0.5 1 square pop");
  const Film film = std::move(test::render_scene(scene, true).film);
  const Metal& silver = *find_metal("Ag");
  const double r_top = 0.6 * 0.6 / (2.6 * 2.6), t = 1.0 - r_top;
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const double r = complex_reflectance(1.0, 1.6, silver.n.at(nm), silver.k.at(nm));
    CHECK(film.radiance(0, 0, b) == Approx(r_top + t * t * r / (1.0 - r * r_top)).epsilon(1e-4));
  }
}
