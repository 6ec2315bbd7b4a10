#include "core/optics/thin_film.h"

#include "core/optics/conductor_reflectance.h"
#include "core/optics/fresnel.h"
#include "core/optics/surface_optics.h"
#include "tests/catch.h"

#include <cmath>
#include <complex>
#include <numbers>

using namespace abbe;

namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

struct Shares {
  double reflected, transmitted;
};

/// The film as a characteristic matrix between two media [BW99, 1.6]: B, C = M (1, y_2), with
/// r = (y_0 B - C) / (y_0 B + C), T = 4 y_0 Re y_2 / |y_0 B + C|^2.
Shares by_matrix(bool p_polarised, double cos_i, double n0, Complex n1, Complex n2, double d,
                 double lambda) {
  const double s = n0 * std::sqrt(1.0 - cos_i * cos_i);
  const auto z = [&](Complex n) {
    const Complex root = std::sqrt(n * n - s * s);
    return root.imag() > 0.0 ? -root : root;
  };
  const auto y = [&](Complex n) { return p_polarised ? n * n / z(n) : z(n); };
  const Complex delta = 2.0 * kPi * d / lambda * z(n1), i(0.0, 1.0);
  const Complex b = std::cos(delta) + i * std::sin(delta) / y(n1) * y(n2);
  const Complex c = i * y(n1) * std::sin(delta) + std::cos(delta) * y(n2);
  const Complex sum = y(n0) * b + c;
  return {std::norm((y(n0) * b - c) / sum), 4.0 * y(n0).real() * y(n2).real() / std::norm(sum)};
}

Shares by_matrix(double cos_i, double n0, Complex n1, Complex n2, double d, double lambda) {
  const Shares s = by_matrix(false, cos_i, n0, n1, n2, d, lambda);
  const Shares p = by_matrix(true, cos_i, n0, n1, n2, d, lambda);
  return {0.5 * (s.reflected + p.reflected), 0.5 * (s.transmitted + p.transmitted)};
}

} // namespace

TEST_CASE("a quarter-wave film reflects ((n0 ns - n1^2) / (n0 ns + n1^2))^2") {
  for (const double n1 : {1.22474487139, 1.38, 2.1})
    for (const double ns : {1.5, 1.9}) {
      const double expected = std::pow((ns - n1 * n1) / (ns + n1 * n1), 2);
      CHECK(thin_film_reflectance(1.0, 1.0, n1, ns, 550.0 / (4.0 * n1), 550.0) ==
            Approx(expected).epsilon(1e-10).margin(1e-14));
    }
}

TEST_CASE("a half-wave film, and one of no thickness, changes nothing") {
  for (const double cos_i : {1.0, 0.7, 0.1})
    for (const double n1 : {1.38, 2.1}) {
      const double cos_1 = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (n1 * n1));
      const double bare = fresnel_reflectance(cos_i, 1.5);
      CHECK(thin_film_reflectance(cos_i, 1.0, n1, 1.5, 600.0 / (2.0 * n1 * cos_1), 600.0) ==
            Approx(bare).epsilon(1e-10));
      CHECK(thin_film_reflectance(cos_i, 1.0, n1, 1.5, 0.0, 600.0) == Approx(bare).epsilon(1e-10));
      CHECK(thin_film_reflectance(cos_i, 1.0, n1, {0.27, -2.9}, 0.0, 600.0) ==
            Approx(conductor_reflectance(cos_i, 1.0, 0.27, 2.9)).epsilon(1e-10));
    }
}

TEST_CASE("a soap film in air reflects by its closed form at normal incidence") {
  // 4 R0 sin^2 d / ((1 - R0)^2 + 4 R0 sin^2 d), R0 = ((n - 1) / (n + 1))^2, d = 2 pi n t / lambda.
  const double n = 1.33, r0 = std::pow(0.33 / 2.33, 2);
  for (const double thickness : {20.0, 100.0, 350.0, 900.0})
    for (double nm = 380.0; nm <= 780.0; nm += 20.0) {
      const double sine = std::sin(2.0 * kPi * n * thickness / nm);
      const double f = 4.0 * r0 * sine * sine;
      CHECK(thin_film_reflectance(1.0, 1.0, n, 1.0, thickness, nm) ==
            Approx(f / ((1.0 - r0) * (1.0 - r0) + f)).epsilon(1e-10).margin(1e-14));
    }
}

TEST_CASE("Airy's sum and characteristic matrices give the same reflectance") {
  for (const double n0 : {1.0, 1.33, 1.7})
    for (const double n1 : {1.0, 1.38, 2.3})
      for (const Complex n2 :
           {Complex(1.0), Complex(1.5), Complex(2.4), Complex(0.27, -2.9), Complex(2.9, -3.1)})
        for (const double d : {15.0, 130.0, 700.0})
          for (const double cos_i : {1.0, 0.8, 0.5, 0.21, 0.03}) {
            INFO(n0 << ' ' << n1 << ' ' << n2 << ' ' << d << ' ' << cos_i);
            const Shares expected = by_matrix(cos_i, n0, n1, n2, d, 510.0);
            const double r = thin_film_reflectance(cos_i, n0, n1, n2, d, 510.0);
            CHECK(r == Approx(expected.reflected).epsilon(1e-9).margin(1e-12));
            if (n2.imag() == 0.0)
              CHECK(1.0 - r == Approx(expected.transmitted).epsilon(1e-9).margin(1e-9));
          }
}

TEST_CASE("light tunnels through a thin film at which it is totally reflected") {
  // Glass, air, glass at 60 degrees: nothing passes a thick gap, nearly all a very thin one.
  CHECK(thin_film_reflectance(0.5, 1.5, 1.0, 1.5, 5000.0, 500.0) == Approx(1.0).epsilon(1e-12));
  CHECK(thin_film_reflectance(0.5, 1.5, 1.0, 1.5, 1.0, 500.0) < 1e-3);
  // Light cannot travel behind the film, so that all of it comes back, whatever the film.
  CHECK(thin_film_reflectance(0.5, 1.5, 1.38, 1.0, 100.0, 500.0) == 1.0);
  // At the film's own critical angle the sum has a limit, which the matrix reaches close to it.
  const double n1 = 1.5 * 0.8; // sin = 0.8, cos = 0.6
  CHECK(thin_film_reflectance(0.6, 1.5, n1, 1.5, 90.0, 500.0) ==
        Approx(by_matrix(0.6 + 1e-7, 1.5, n1, 1.5, 90.0, 500.0).reflected).epsilon(1e-5));
}

TEST_CASE("grazing light is reflected by any film") {
  CHECK(thin_film_reflectance(0.0, 1.0, 1.38, 1.5, 100.0, 500.0) == 1.0);
  CHECK(thin_film_reflectance(1e-9, 1.0, 1.38, 1.5, 100.0, 500.0) == Approx(1.0).epsilon(1e-7));
  CHECK(thin_film_reflectance(0.0, 1.0, 1.38, {0.2, -3.0}, 100.0, 500.0) == 1.0);
}

TEST_CASE("the optics of a surface, with and without film, per band") {
  const double n_before[] = {1.0, 1.0, 1.5}, n_after[] = {1.5, 1.5, 1.0};
  const double film_index[] = {1.38, 1.38, 1.38}, nm[] = {450.0, 600.0, 600.0};
  SurfaceOptics optics;
  optics.n_before = n_before;
  optics.n_after = n_after;
  CHECK(optics.alike(0, 2));
  CHECK_FALSE(optics.alike(0, 3));
  CHECK(optics.fractions(0, 0.7).reflected == Approx(fresnel_reflectance(0.7, 1.5)));
  CHECK(optics.fractions(0, 0.7).transmitted == Approx(1.0 - fresnel_reflectance(0.7, 1.5)));
  CHECK(optics.fractions(2, 0.5).reflected == 1.0);
  CHECK(optics.fractions(2, 0.5).transmitted == 0.0);
  optics.film = {130.0, film_index, nm};
  CHECK_FALSE(optics.alike(0, 2));
  CHECK(optics.alike(0, 1));
  for (int b = 0; b < 2; ++b) {
    const Shares expected = by_matrix(0.7, 1.0, 1.38, 1.5, 130.0, nm[b]);
    CHECK(optics.fractions(b, 0.7).reflected == Approx(expected.reflected));
    CHECK(optics.fractions(b, 0.7).transmitted == Approx(expected.transmitted));
  }
  optics.fresnel = false;
  CHECK(optics.fractions(0, 0.7).reflected == 1.0);
  CHECK(optics.fractions(0, 0.7).transmitted == 1.0);
  CHECK(optics.fractions(2, 0.5).transmitted == 0.0);
  const float n[] = {0.27f, 0.27f, 0.3f}, k[] = {2.9f, 2.9f, 2.0f};
  SurfaceOptics metal;
  metal.n_before = n_before;
  metal.opaque = true;
  metal.metal_n = n;
  metal.metal_k = k;
  CHECK(metal.alike(0, 2));
  CHECK_FALSE(metal.alike(1, 3));
  CHECK(metal.fractions(0, 0.3).reflected == Approx(conductor_reflectance(0.3, 1.0, 0.27f, 2.9f)));
  CHECK(metal.fractions(0, 0.3).transmitted == 0.0);
  metal.film = {200.0, film_index, nm};
  CHECK(metal.fractions(1, 0.3).reflected ==
        Approx(by_matrix(0.3, 1.0, 1.38, Complex(0.27f, -2.9f), 200.0, 600.0).reflected));
}
