#pragma once

#include "spectral/dispersion.h"

#include <span>

namespace abbe {

// The dispersion formulas of glass files, by their numbers. Wavelengths are in micrometres. Those
// that are no law of ours (see DispersionLaw) become tables of one point per nm, which are off by
// less than 1e-8. All throw std::invalid_argument for a number that names no formula, coefficients
// that do not fit it, and an index that is no number in the visible range.

/// Formulas 1 to 13 of Zemax's catalogues (.agf). Coefficients that are left out are 0.
[[nodiscard]] Dispersion agf_law(int formula, std::span<const double> coefficients);

/// Formulas 1 to 9 of refractiveindex.info [Pol24].
[[nodiscard]] Dispersion refractiveindex_law(int formula, std::span<const double> coefficients);

} // namespace abbe
