#pragma once

#include "spectral/dispersion_laws.h"

#include <variant>

namespace abbe {

/// A refractive index as a function of wavelength. A new law (Cauchy, Abbe number, table) is one
/// struct with its `refractive_index` and `is_achromatic`, and one name here.
using Dispersion = std::variant<ConstantIndex, ThesisPolynomial, ThesisLinear, ThesisScaled,
                                Sellmeier, PowerSeries, Formula4, GasFormula>;

/// Fraunhofer lines in nm: d (He), F and C (H) [TIE29].
inline constexpr double kLineD_nm = 587.5618;
inline constexpr double kLineF_nm = 486.1327;
inline constexpr double kLineC_nm = 656.2725;

/// n at a wavelength in nm. A law is a formula and knows no range: it extrapolates.
/// NaN where n squared would be negative, which no law here does between 377.5 and 782.5 nm.
[[nodiscard]] double refractive_index(const Dispersion& law, double lambda_nm);

/// True when n does not depend on wavelength.
[[nodiscard]] bool is_achromatic(const Dispersion& law);

/// The Abbe number V_d = (n_d - 1) / (n_F - n_C); infinite for an achromatic law.
[[nodiscard]] double abbe_number(const Dispersion& law);

} // namespace abbe
