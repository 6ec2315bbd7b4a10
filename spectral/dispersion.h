#pragma once

#include "spectral/cauchy.h"
#include "spectral/dispersion_laws.h"
#include "spectral/fraunhofer.h"
#include "spectral/tabulated_index.h"

#include <utility>
#include <variant>

namespace abbe {

/// A refractive index as a function of wavelength. A new law is one struct with its
/// `refractive_index` and `is_achromatic`, and one name here.
using DispersionLaw =
    std::variant<ConstantIndex, ThesisPolynomial, ThesisLinear, ThesisScaled, Sellmeier,
                 PowerSeries, Formula4, GasFormula, Cauchy, TabulatedIndex>;

/// A law with its dispersion exaggerated about n_d, as the thesis did to show it [War05]:
/// n = n_d + factor (n_law - n_d).
struct ExaggeratedDispersion {
  DispersionLaw law;
  double n_d = 1.0; ///< of the law
  double factor = 1.0;
  friend bool operator==(const ExaggeratedDispersion&, const ExaggeratedDispersion&) = default;
};

/// Any of the laws, or one exaggerated.
template <class... Laws>
std::variant<Laws..., ExaggeratedDispersion> with_exaggeration(std::variant<Laws...>);
using Dispersion = decltype(with_exaggeration(std::declval<DispersionLaw>()));

/// n at a wavelength in nm. A formula knows no range: it extrapolates; a table holds its ends.
/// NaN where n squared would be negative, which no glass of the catalogue does between 377.5 and
/// 782.5 nm.
[[nodiscard]] double refractive_index(const Dispersion& law, double lambda_nm);

/// True when n does not depend on wavelength.
[[nodiscard]] bool is_achromatic(const Dispersion& law);

/// The Abbe number V_d = (n_d - 1) / (n_F - n_C); infinite for an achromatic law.
[[nodiscard]] double abbe_number(const Dispersion& law);

/// The law with the same n_d and `factor` times its dispersion. The law may be exaggerated already.
[[nodiscard]] Dispersion exaggerated(const Dispersion& law, double factor);

} // namespace abbe
