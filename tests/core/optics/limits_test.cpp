// Fresnel's equations, films and metals where their formulas are in danger: equal and nearly equal
// media, critical and grazing angles, films of no and of endless thickness. References are the same
// laws in long double.

#include "core/optics/conductor_reflectance.h"
#include "core/optics/diffuse_fresnel.h"
#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"
#include "tests/catch.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

using namespace abbe;

namespace {

using Real = long double;
using Complex = std::complex<Real>;
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Indices on both sides: equal, nearly equal on either side, far apart, below 1.
std::vector<std::pair<double, double>> media() {
  std::vector<std::pair<double, double>> pairs;
  for (const double n : {1.0, 1.5, 0.3, 1e-3, 1e3}) {
    pairs.emplace_back(n, n);
    for (double step = 1e-3; step > 5e-16; step *= 0.1) {
      pairs.emplace_back(n, n * (1.0 + step));
      pairs.emplace_back(n, n * (1.0 - step));
    }
  }
  for (const double n : {1.1, 1.5, 2.4, 4.0, 100.0, 1e6})
    for (const double other : {1.0, 0.5})
      for (const bool inside : {false, true})
        pairs.emplace_back(inside ? n : other, inside ? other : n);
  return pairs;
}

/// Cosines from 1 to 0, with that of the critical angle and its neighbours, where there is one. The
/// squares of the last ones are 0: such light runs along the surface.
std::vector<double> cosines(double eta) {
  std::vector<double> all{1.0,    std::nextafter(1.0, 0.0),
                          0.9,    0.5,
                          0.1,    1e-3,
                          1e-5,   1e-7,
                          1e-8,   1e-9,
                          1e-12,  1e-100,
                          1e-170, kLeast,
                          0.0};
  if (eta < 1.0) {
    const double critical = std::sqrt((1.0 - eta) * (1.0 + eta));
    for (const double c : {critical, std::nextafter(critical, 1.0), std::nextafter(critical, 0.0),
                           critical * (1.0 + 1e-12), critical * (1.0 - 1e-12)})
      if (c <= 1.0) all.push_back(c);
  }
  return all;
}

bool grazes(double cosine) {
  return cosine * cosine == 0.0;
}

/// n cos(theta) in a medium, summed so that nothing cancels.
Complex along_normal(Real cos_i, Real n_before, Complex n) {
  const Complex root =
      std::sqrt((n - n_before) * (n + n_before) + n_before * n_before * cos_i * cos_i);
  return root.imag() > 0.0L ? -root : root;
}

/// Fresnel's reflectance by complex amplitudes: for glass and for metals.
double reflectance(Real cos_i, Real n_before, Complex n) {
  if (grazes(static_cast<double>(cos_i))) return 1.0;
  const Complex z0 = n_before * cos_i, z = along_normal(cos_i, n_before, n);
  const Complex s = (z0 - z) / (z0 + z);
  const Complex p = (n * n * z0 - n_before * n_before * z) / (n * n * z0 + n_before * n_before * z);
  return static_cast<double>(0.5L * (std::norm(s) + std::norm(p)));
}

/// By how much the last place of an index, or of the cosine, changes the reflectance: near a
/// critical angle that is much more than a last place.
double uncertainty(double cos_i, double n_before, double n_after) {
  double most = 0.0;
  const double here = reflectance(cos_i, n_before, n_after);
  for (const double step : {-4e-16, 4e-16}) {
    most = std::max(most, std::abs(reflectance(cos_i, n_before, n_after + n_after * step) - here));
    if (cos_i < 1.0)
      most = std::max(most, std::abs(reflectance(cos_i + cos_i * step, n_before, n_after) - here));
  }
  return most;
}

/// Airy's sum, where light may be absorbed behind.
double film_reflectance(Real cos_i, Real n0, Real n1, Complex n2, Real thickness, Real lambda) {
  const Complex z0 = n0 * cos_i, z1 = along_normal(cos_i, n0, n1), z2 = along_normal(cos_i, n0, n2);
  const Complex turn =
      std::exp(Complex(0.0L, -4.0L * std::numbers::pi_v<Real> * thickness / lambda) * z1);
  const auto airy = [&](Complex y0, Complex y1, Complex y2) {
    const Complex r01 = (y0 - y1) / (y0 + y1), r12 = (y1 - y2) / (y1 + y2);
    return std::norm((r01 + r12 * turn) / (1.0L + r01 * r12 * turn));
  };
  return static_cast<double>(0.5L *
                             (airy(z0, z1, z2) + airy(n0 * n0 / z0, n1 * n1 / z1, n2 * n2 / z2)));
}

} // namespace

TEST_CASE("Fresnel's equations hold at the limits: R + T = 1, and R is right to the last places") {
  for (const auto& [before, after] : media())
    for (const double c : cosines(after / before)) {
      CAPTURE(before, after, c);
      const Fractions f = dielectric_fractions(true, c, before, after);
      REQUIRE(f.reflected >= 0.0);
      REQUIRE(f.transmitted >= 0.0);
      REQUIRE(f.reflected + f.transmitted == 1.0);
      const double margin = 1e-9 + 2.0 * uncertainty(c, before, after);
      REQUIRE(f.reflected == Approx(reflectance(c, before, after)).margin(margin));
      REQUIRE(fresnel_reflectance(c, after / before) == Approx(f.reflected).margin(margin));
    }
}

TEST_CASE("equal media reflect nothing, down to where the cosine's square is no number") {
  for (const double n : {1.0, 1.5, 0.3})
    for (const double c : cosines(1.0)) {
      CAPTURE(n, c);
      const double expected = grazes(c) ? 1.0 : 0.0;
      CHECK(dielectric_fractions(true, c, n, n).reflected == expected);
      CHECK(conductor_reflectance(c, n, n, 0.0) == Approx(expected).margin(1e-30));
      CHECK(thin_film_reflectance(c, n, n, n, 300.0, 550.0) == expected);
    }
}

TEST_CASE("what Fresnel's equations let through has a direction, and that obeys Snell's law") {
  for (const auto& [before, after] : media())
    for (const double c : cosines(after / before)) {
      CAPTURE(before, after, c);
      const double eta = after / before;
      const auto cos_t = refracted_cosine(c, eta);
      REQUIRE(cos_t.has_value() == (dielectric_fractions(false, c, before, after).transmitted > 0));
      if (!cos_t) continue;
      REQUIRE(*cos_t >= 0.0);
      REQUIRE(*cos_t <= 1.0);
      const double sin_i = std::sqrt(1.0 - c * c);
      const dvec3 out = refracted({sin_i, -c, 0.0}, {0.0, 1.0, 0.0}, c, *cos_t, eta);
      REQUIRE(std::abs(glm::length(out) - 1.0) < 1e-15);
      // At the critical angle of a much denser medium the last place of the cosine is more.
      if (eta > 0.1) REQUIRE(out.x * eta == Approx(sin_i).margin(1e-14));
    }
}

TEST_CASE("metals hold at the limits: k from 0 to huge, n from 0 to huge") {
  for (const double before : {1.0, 1.5})
    for (const double n : {0.0, 1e-30, 0.2, 1.0, 1.5, 3.0, 1e10, 1e30})
      for (const double k : {0.0, kLeast, 1e-300, 1e-30, 1e-10, 1.0, 1e10, 1e30})
        for (const double c : cosines(1.0)) {
          CAPTURE(before, n, k, c);
          const double r = conductor_reflectance(c, before, n, k);
          REQUIRE(r >= 0.0);
          REQUIRE(r <= 1.0 + 1e-15);
          if (n > 0.0) REQUIRE(r == Approx(reflectance(c, before, Complex(n, -k))).margin(1e-9));
        }
}

TEST_CASE("films hold at the limits: no thickness and endless, equal media, critical angles") {
  for (const double n0 : {1.0, 1.5, 2.4})
    for (const double n1 : {1.0, 1.38, 1.5, 1.5 * (1.0 + 1e-12), 2.4, 0.3})
      for (const std::complex<double> n2 :
           {std::complex<double>(1.0), std::complex<double>(1.5),
            std::complex<double>(1.5 * (1.0 + 1e-15)), std::complex<double>(0.2, -3.0),
            std::complex<double>(0.1, -1e30)})
        for (const double thickness : {0.0, 1e-300, 1e-9, 0.1, 100.0, 1e4, 1e6, 1e12, 1e30})
          for (const double c : cosines(std::min(n1, n2.real()) / n0)) {
            CAPTURE(n0, n1, n2, thickness, c);
            const double r = thin_film_reflectance(c, n0, n1, n2, thickness, 550.0);
            REQUIRE(r >= 0.0);
            REQUIRE(r <= 1.0);
            const bool passes = n2.imag() != 0.0 || refracted_part2(c, n2.real() / n0) > 0.0;
            if (grazes(c)) REQUIRE(r == 1.0);
            if (!passes) REQUIRE(r > 1.0 - 1e-6);
            if (!passes || c < 1e-12 || thickness > 1e5) continue; // turns have no digits left
            REQUIRE(r == Approx(film_reflectance(c, n0, n1, n2, thickness, 550.0)).margin(1e-6));
          }
}

TEST_CASE("a film counts in arrays as it counts alone, at the limits too") {
  const double nm[] = {400.0, 550.0, 700.0};
  for (const double n0 : {1.0, 1.5})
    for (const double n1 : {1.0, 1.38, 2.4})
      for (const double n2 : {1.0, 1.5})
        for (const double c : cosines(std::min(n1, n2) / n0)) {
          const double before[] = {n0, n0, n0}, film[] = {n1, n1, n1}, after[] = {n2, n2, n2};
          float r[3] = {};
          thin_film_reflectances(c, before, {300.0, film, nm}, after, {r, {0, 3}});
          for (int b = 0; b < 3; ++b) {
            CAPTURE(n0, n1, n2, c, b);
            REQUIRE(r[b] == static_cast<float>(thin_film_reflectance(c, n0, n1, n2, 300.0, nm[b])));
          }
        }
}

// 2 times the integral of T(mu) mu, by midpoints in the square root of mu.
TEST_CASE("the mean transmittance is right for nearly equal media too") {
  constexpr int kSteps = 20000;
  for (const double step : {0.0, 1e-15, 1e-9, 1e-6, 9e-6, 4.9e-5, 5.1e-5, 1e-4, 1e-3, 0.1, 0.5})
    for (const double eta : {1.0 + step, 1.0 / (1.0 + step)}) {
      double sum = 0.0;
      for (int i = 0; i < kSteps; ++i) {
        const double root = (i + 0.5) / kSteps;
        sum += 4.0 * root * root * root * (1.0 - fresnel_reflectance(root * root, eta)) / kSteps;
      }
      CAPTURE(eta);
      CHECK(diffuse_transmittance(eta) == Approx(sum).margin(2e-7));
    }
}
