#include "tests/stress/furnace/reference_optics.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace abbe::stress {
namespace {

using Real = long double;
using Complex = std::complex<Real>;

enum class Polarisation { s, p };

/// Of a wave in a medium, for the tangential fields: n cos for s, n / cos for p.
Complex admittance(Polarisation polarisation, Real n, Complex cosine) {
  return polarisation == Polarisation::s ? n * cosine : n / cosine;
}

/// The cosine in a medium where `across` = n sin, imaginary beyond the critical angle.
Complex cosine_in(Real n, Real across) {
  return std::sqrt(Complex(1 - across / n * (across / n)));
}

} // namespace

Split filmed_split(Real sine, Real n_before, const FilmLayer& film, Real n_after) {
  const Real across = n_before * sine;
  if (across >= n_after) return {1, 0};
  const Complex cos_before = cosine_in(n_before, across), cos_film = cosine_in(film.index, across),
                cos_after = cosine_in(n_after, across);
  const Complex phase =
      2 * std::numbers::pi_v<Real> * film.index * film.thickness_nm / film.lambda_nm * cos_film;
  Real reflected = 0;
  for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
    const Complex y0 = admittance(polarisation, n_before, cos_before),
                  y1 = admittance(polarisation, film.index, cos_film),
                  y2 = admittance(polarisation, n_after, cos_after);
    const Complex i(0, 1);
    const Complex b = std::cos(phase) + i * std::sin(phase) * y2 / y1;
    const Complex c = i * y1 * std::sin(phase) + y2 * std::cos(phase);
    reflected += std::norm((y0 * b - c) / (y0 * b + c)) / 2;
  }
  return {reflected, 1 - reflected};
}

Split boundary_split(Real sine, Real n_before, Real n_after) {
  return filmed_split(sine, n_before, {n_after, 0, 500}, n_after);
}

Split pane_split(Real sine, Real n_around, const PaneLayer& pane) {
  const Real across = n_around * sine;
  if (across >= pane.index) return {1, 0};
  const Real cos_i = std::sqrt((1 - sine) * (1 + sine));
  const Real cos_t = cosine_in(pane.index, across).real();
  const Real kept = std::exp(-pane.absorption * pane.thickness / cos_t);
  Split both{0, 0};
  for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
    const Real y0 = admittance(polarisation, n_around, cos_i).real(),
               y1 = admittance(polarisation, pane.index, cos_t).real();
    const Real r = (y0 - y1) / (y0 + y1) * ((y0 - y1) / (y0 + y1));
    Real reflected = r, passed = 0, inside = 1 - r;
    for (int face = 1; inside > 1e-20L && face < 100000; ++face) {
      inside *= kept;
      (face % 2 != 0 ? passed : reflected) += inside * (1 - r);
      inside *= r;
    }
    both.reflected += reflected / 2;
    both.passed += passed / 2;
  }
  return both;
}

} // namespace abbe::stress
