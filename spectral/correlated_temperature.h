#pragma once

#include "spectral/color.h"

#include <optional>

namespace abbe {

/// The temperature of the Planckian radiator whose colour is nearest to a light's.
struct CorrelatedTemperature {
  double kelvin = 0.0;
  /// The distance in the CIE 1960 u, v, which are u' and 2v'/3; above 0 on the green side of the
  /// radiators, below 0 on the pink one.
  double duv = 0.0;
};

/// Of a chromaticity as the 2 degree observer sees it. Empty where the distance is more than 0.05,
/// from where on the CIE has no such temperature [CIE15, 9.4], and outside of 1000-100000 K.
[[nodiscard]] std::optional<CorrelatedTemperature> correlated_temperature(const Chromaticity& c);

} // namespace abbe
