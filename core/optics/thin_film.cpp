#include "core/optics/thin_film.h"

#include "geometry/solids/circle_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {
namespace {

using Complex = std::complex<double>;

/// The square of n cos(theta) of the wave inside a medium, where it is `z0` in the medium before:
/// n sin(theta) is the same in all media. The sum does not cancel where the indices are nearly
/// equal.
template <class Index>
Index along_normal2(Index n, double n_before, double z0) {
  return (n - n_before) * (n + n_before) + z0 * z0;
}

/// n cos(theta), for waves e^{i omega t}: the root whose wave does not grow with depth.
Complex along_normal(Complex n, double n_before, double z0) {
  const Complex root = std::sqrt(along_normal2(n, n_before, z0));
  return root.imag() > 0.0 ? -root : root;
}

/// Airy's sum for one polarisation, from the media's admittances y: r = (y_i - y_t) / (y_i + y_t).
/// `turn` is e^{-2 i delta}.
double airy(Complex y0, Complex y1, Complex y2, Complex turn) {
  const Complex r01 = (y0 - y1) / (y0 + y1), r12 = (y1 - y2) / (y1 + y2);
  return std::norm((r01 + r12 * turn) / (1.0 + r01 * r12 * turn));
}

/// As thin_film_reflectance, where light travels in all three media. With z = n cos(theta) in each,
/// sin^2 and cos^2 in Airy's sum of real amplitudes come together as
///   R_s = ((z0 - z2)^2 + Q F) / ((z0 + z2)^2 + Q F),   F = sin^2(delta) / z1^2,
///   Q = (z1^2 - z0^2) (z1^2 - z2^2) = (n1^2 - n0^2) (n1^2 - n2^2),
///   R_p = ((n0^2 z2 - n2^2 z0)^2 + P F) / ((n0^2 z2 + n2^2 z0)^2 + P F),
///   P = (n1^4 z0^2 - n0^4 z1^2) (n1^4 z2^2 - n2^4 z1^2) / n1^4,
/// in which nothing is 0 / 0 at the film's critical angle, where F = (2 pi d / lambda)^2.
[[gnu::always_inline]] inline double clear_film_reflectance(double z0, double n_before,
                                                            double n_film, double n_behind,
                                                            double turns_per_index) {
  const double step1 = (n_film - n_before) * (n_film + n_before);
  const double step2 = (n_behind - n_before) * (n_behind + n_before);
  const double z0_2 = z0 * z0;
  const double z1_2 = std::max(step1 + z0_2, 0.0), z2_2 = std::max(step2 + z0_2, 0.0);
  const double z1 = std::sqrt(z1_2), z2 = std::sqrt(z2_2);
  const double sine = sine_of_turns(turns_per_index * z1);
  const double at_critical = 2.0 * std::numbers::pi * turns_per_index;
  const double quotient = z1 > 0.0 ? sine / z1 : at_critical;
  const double f = quotient * quotient;
  const double n0_2 = n_before * n_before, n1_2 = n_film * n_film, n2_2 = n_behind * n_behind;
  const double q = step1 * ((n_film - n_behind) * (n_film + n_behind)) * f;
  const double p =
      (n1_2 * z0_2 - n0_2 * (n0_2 / n1_2) * z1_2) * (n1_2 * z2_2 - n2_2 * (n2_2 / n1_2) * z1_2) * f;
  const double across = z0 - z2, both = z0 + z2;
  const double along = n0_2 * z2 - n2_2 * z0, both_along = n0_2 * z2 + n2_2 * z0;
  const double s_part = (across * across + q) / (both * both + q);
  const double p_part = (along * along + p) / (both_along * both_along + p);
  return std::clamp(0.5 * (s_part + p_part), 0.0, 1.0);
}

/// True where light travels in the film and behind it.
bool is_clear(double n_before, double n_film, double n_behind, double z0) {
  return along_normal2(n_film, n_before, z0) >= 0.0 && along_normal2(n_behind, n_before, z0) > 0.0;
}

/// True where light runs along the surface, or so close to it that the squares above are 0. All of
/// it is reflected.
bool grazes(double z0) {
  return z0 * z0 == 0.0;
}

} // namespace

double thin_film_reflectance(double cos_i, double n_before, double n_film, Complex n_behind,
                             double thickness_nm, double lambda_nm) {
  const double z0 = n_before * cos_i;
  if (grazes(z0)) return 1.0;
  const bool clear = n_behind.imag() == 0.0;
  if (clear && !(along_normal2(n_behind.real(), n_before, z0) > 0.0)) return 1.0;
  if (clear && is_clear(n_before, n_film, n_behind.real(), z0))
    return clear_film_reflectance(z0, n_before, n_film, n_behind.real(), thickness_nm / lambda_nm);
  Complex z1 = along_normal(n_film, n_before, z0);
  // At the film's critical angle the quotients below are 0 / 0 with a limit. Rounding of n^2 - s^2
  // leaves z1 uncertain by this much, which therefore may take the place of 0.
  if (z1 == 0.0) z1 = n_film * std::sqrt(std::numeric_limits<double>::epsilon());
  const Complex z2 = along_normal(n_behind, n_before, z0);
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
  for (int b = first; b < last; ++b)
    reflectances[b] = static_cast<float>(clear_film_reflectance(
        n_before[b] * cos_i, n_before[b], n_film[b], n_behind[b], thickness_nm / lambda_nm[b]));
  for (int b = first; b < last; ++b)
    if (grazes(n_before[b] * cos_i) ||
        !is_clear(n_before[b], n_film[b], n_behind[b], n_before[b] * cos_i))
      reflectances[b] = static_cast<float>(thin_film_reflectance(
          cos_i, n_before[b], n_film[b], n_behind[b], thickness_nm, lambda_nm[b]));
}

} // namespace abbe
