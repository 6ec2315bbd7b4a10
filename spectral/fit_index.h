#pragma once

#include "spectral/dispersion_laws.h"

#include <vector>

namespace abbe {

/// A law fitted to measured indices, and how far it misses them.
struct IndexFit {
  PowerSeries law;
  double largest_residual = 0.0; ///< of n, over the points
  double worst_nm = 0.0;         ///< where that is
};

/// The least squares fit of Schott's older formula n^2 = a0 + a1 L^-2 + a2 L^-4 + a3 L^2 to points
/// (nm, n), L in um; as many of its terms as there are points, in this order. Its terms follow the
/// resonances of glass in the ultraviolet and infrared, so that it bends as glass does between the
/// points and beyond them, where the thesis's quintic in L wavers.
/// Throws std::invalid_argument when the lengths differ, the wavelengths are not positive and
/// ascending, an n is not above 0, or there is no point.
[[nodiscard]] IndexFit fit_index(const std::vector<double>& wavelengths_nm,
                                 const std::vector<double>& n);

} // namespace abbe
