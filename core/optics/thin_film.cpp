#include "core/optics/thin_film.h"

#include "geometry/solids/circle_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {
namespace {

using Complex = std::complex<double>;

/// n cos(theta) of the wave inside a medium, for waves e^{i omega t}: the root whose wave does not
/// grow with depth. `across` = n sin(theta) is the same in all media.
Complex along_normal(Complex n, double across) {
  const Complex root = std::sqrt(n * n - across * across);
  return root.imag() > 0.0 ? -root : root;
}

/// Airy's sum for one polarisation, from the media's admittances y: r = (y_i - y_t) / (y_i + y_t).
/// `turn` is e^{-2 i delta}.
double airy(Complex y0, Complex y1, Complex y2, Complex turn) {
  const Complex r01 = (y0 - y1) / (y0 + y1), r12 = (y1 - y2) / (y1 + y2);
  return std::norm((r01 + r12 * turn) / (1.0 + r01 * r12 * turn));
}

/// Airy's sum without absorption and without total reflection in the film, where all but the turn
/// is real, with r_01 = a / b and r_12 = c / d and over one denominator. `phase_cosine` is the
/// turn's real part.
double airy(double y0, double y1, double y2, double phase_cosine) {
  const double a = y0 - y1, b = y0 + y1, c = y1 - y2, d = y1 + y2;
  const double both = 2.0 * (a * b) * (c * d) * phase_cosine;
  const double ad = a * d, cb = c * b, bd = b * d, ac = a * c;
  return (ad * ad + cb * cb + both) / (bd * bd + ac * ac + both);
}

/// As thin_film_reflectance, where all is real. The admittances for p are n^2 / z, here multiplied
/// by all three z.
[[gnu::always_inline]] inline double clear_film_reflectance(double z0, double n_before,
                                                            double n_film, double n_behind,
                                                            double across2,
                                                            double turns_per_index) {
  const double z1 = std::sqrt(std::max(n_film * n_film - across2, 0.0));
  const double z2 = std::sqrt(std::max(n_behind * n_behind - across2, 0.0));
  const double cosine = cosine_of_turns(turns_per_index * z1);
  const double s = airy(z0, z1, z2, cosine);
  const double p = airy(n_before * n_before * (z1 * z2), n_film * n_film * (z0 * z2),
                        n_behind * n_behind * (z0 * z1), cosine);
  return std::clamp(0.5 * (s + p), 0.0, 1.0);
}

/// Near the film's critical angle cancellation costs the real form digits, in proportion to 1 over
/// the squared cosine. Above this squared cosine it keeps twelve digits.
constexpr double kLeastCosine2 = 1e-4;

/// True where the real form holds and light reaches the medium behind.
bool is_clear(double n_film, double n_behind, double across2) {
  return across2 < (1.0 - kLeastCosine2) * (n_film * n_film) && across2 < n_behind * n_behind;
}

} // namespace

double thin_film_reflectance(double cos_i, double n_before, double n_film, Complex n_behind,
                             double thickness_nm, double lambda_nm) {
  const double across = n_before * std::sqrt(std::max(0.0, 1.0 - cos_i * cos_i));
  if (n_behind.imag() == 0.0 && across >= n_behind.real()) return 1.0;
  const double z0 = n_before * cos_i;
  if (z0 == 0.0) return 1.0;
  if (n_behind.imag() == 0.0 && is_clear(n_film, n_behind.real(), across * across))
    return clear_film_reflectance(z0, n_before, n_film, n_behind.real(), across * across,
                                  2.0 * thickness_nm / lambda_nm);
  Complex z1 = along_normal(n_film, across);
  // At the film's critical angle the quotients below are 0 / 0 with a limit. Rounding of n^2 - s^2
  // leaves z1 uncertain by this much, which therefore may take the place of 0.
  if (z1 == 0.0) z1 = n_film * std::sqrt(std::numeric_limits<double>::epsilon());
  const Complex z2 = along_normal(n_behind, across);
  const Complex turn =
      std::exp(Complex(0.0, -4.0 * std::numbers::pi * thickness_nm / lambda_nm) * z1);
  const double s = airy(z0, z1, z2, turn);
  const double p =
      airy(n_before * n_before / z0, n_film * n_film / z1, n_behind * n_behind / z2, turn);
  return std::min(1.0, 0.5 * (s + p));
}

void thin_film_reflectances(double cos_i, const double* n_before, const FilmOptics& film,
                            const double* n_behind, BandSpan<float> reflectances) {
  const auto [first, last] = reflectances.bands;
  const double thickness_nm = film.thickness_nm;
  const double* n_film = film.index;
  const double* lambda_nm = film.lambda_nm;
  const double sine2 = std::max(0.0, 1.0 - cos_i * cos_i);
  for (int b = first; b < last; ++b)
    reflectances[b] = static_cast<float>(clear_film_reflectance(
        n_before[b] * cos_i, n_before[b], n_film[b], n_behind[b], n_before[b] * n_before[b] * sine2,
        2.0 * thickness_nm / lambda_nm[b]));
  for (int b = first; b < last; ++b)
    if (cos_i == 0.0 || !is_clear(n_film[b], n_behind[b], n_before[b] * n_before[b] * sine2))
      reflectances[b] = static_cast<float>(thin_film_reflectance(
          cos_i, n_before[b], n_film[b], n_behind[b], thickness_nm, lambda_nm[b]));
}

} // namespace abbe
