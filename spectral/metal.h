#pragma once

#include "spectral/curve.h"

#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A metal by its complex refractive index n - i k, both tabulated over wavelength (nm).
struct Metal {
  std::string name; ///< chemical symbol
  Curve n;
  Curve k; ///< positive: absorbing
};

/// The built-in metals, sorted by symbol, linear between the measured points: Ag, Au, Cu [JC72],
/// Cr, Fe, Ni, Ti [JC74], Al [Rak95], Pt [RDEM98], W [WOL75].
[[nodiscard]] const std::vector<Metal>& metal_catalogue();

/// The built-in metal of this symbol, in upper or lower case; null when there is none. It lives as
/// long as the program.
[[nodiscard]] const Metal* find_metal(std::string_view symbol);

} // namespace abbe
