#pragma once

#include "spectral/curve.h"
#include "spectral/radiator.h" // blackbody, cie_daylight: lights by temperature instead of name

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A CIE illuminant by name (A, D65, FL2, LED-B1 ...; upper or lower case), scaled to Y = 1 at 81
/// bands for the 2 degree observer. The tables [CIE15] are read at 380, 385 ... 780 nm,
/// linear between where their step is not 5 nm. E is the constant 1. Empty for an unknown name.
[[nodiscard]] std::optional<Curve> find_illuminant(std::string_view name);

/// The names that find_illuminant knows, sorted.
[[nodiscard]] std::vector<std::string> illuminant_names();

} // namespace abbe
