#pragma once

#include "spectral/color.h"
#include "spectral/observer.h"

#include <span>
#include <vector>

namespace abbe {

/// Per band of a spectrum that is given at ascending wavelengths (nm), the XYZ of a value of 1 per
/// nm in this band alone, so that the colour of the spectrum is a sum of products. An equal-energy
/// spectrum of 1 has Y = 1.
///
/// The centres of a BandGrid stand for its bands. At all other wavelengths the spectrum is linear
/// between two of them, goes on level for half a step beyond the first and the last, and is 0
/// farther out; a single wavelength stands for 5 nm.
[[nodiscard]] std::vector<Xyz> colors_of_bands(std::span<const double> wavelengths_nm,
                                               Observer observer);

} // namespace abbe
