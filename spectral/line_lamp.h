#pragma once

#include "spectral/curve.h"

namespace abbe {

/// Light of one wavelength, as of a laser, scaled to Y = 1 for the 2 degree observer. Its colour is
/// the observer's at this wavelength, whatever the bands.
/// Throws std::invalid_argument outside 380-780 nm.
[[nodiscard]] Curve line_lamp(double lambda_nm);

/// A low pressure sodium lamp: its D lines at 588.995 and 589.592 nm in air, 2 : 1 [NIST], Y = 1.
[[nodiscard]] Curve sodium_lamp();

} // namespace abbe
