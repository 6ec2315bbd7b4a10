#pragma once

#include "spectral/curve.h"

namespace abbe {

/// A Planckian radiator, scaled to Y = 1 at 81 bands for the 2 degree observer, from the exact h, c
/// and k of [CODATA18]. Wavelengths are taken as in vacuum.
/// Throws std::invalid_argument unless the temperature is positive and finite.
[[nodiscard]] Curve blackbody(double kelvin);

/// A phase of daylight from the CIE's three components [CIE15], scaled like the radiator. M1 and M2
/// are rounded to three decimals, as the CIE does. D65 is cie_daylight(6500 * 1.4388 / 1.4380).
/// Throws std::invalid_argument outside 4000-25000 K, where the CIE does not define it.
[[nodiscard]] Curve cie_daylight(double kelvin);

} // namespace abbe
