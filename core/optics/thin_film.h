#pragma once

#include "core/bands/band_span.h"

#include <complex>

namespace abbe {

/// The reflectance of unpolarised light at a film between two media, by Airy's sum over the
/// reflections inside it [BW99, 7.6 and 14.4]:
///   r = (r_01 + r_12 e^{-2 i delta}) / (1 + r_01 r_12 e^{-2 i delta}),
///   delta = 2 pi n_film d cos(theta_film) / lambda,
/// for each polarisation with Fresnel's amplitudes; then the mean of |r|^2. `n_behind` = n - i k
/// may be a metal's. Where it is real, nothing is absorbed, and 1 minus the reflectance is
/// transmitted; the reflectance is then 1 under total reflection, however thin the film.
/// Lengths are in nm; the wavelength is that in air, as for the indices.
[[nodiscard]] double thin_film_reflectance(double cos_i, double n_before, double n_film,
                                           std::complex<double> n_behind, double thickness_nm,
                                           double lambda_nm);

/// A film on a boundary, at the bands.
struct FilmOptics {
  double thickness_nm = 0.0;         ///< 0: there is none
  const double* index = nullptr;     ///< per band, real
  const double* lambda_nm = nullptr; ///< per band, the wavelength at which `index` was taken
};

/// The same between clear media, whose indices are arrays over bands, for the bands of
/// `reflectances`, several at once.
void thin_film_reflectances(double cos_i, const double* n_before, const FilmOptics& film,
                            const double* n_behind, BandSpan<float> reflectances);

} // namespace abbe
