#pragma once

#include "io/text/read_arguments.h"
#include "spectral/curve.h"

namespace abbe {

// What scenes and material libraries say in the same words about coloured glass.

inline constexpr std::string_view kAbsorptionTableUsage = "absorptionTable COUNT nm a ...";
inline constexpr std::string_view kInternalTransmittanceUsage =
    "internalTransmittance r g b thickness";

/// Absorption per mm at ascending wavelengths.
[[nodiscard]] Curve read_absorption_table(Arguments& arguments);

/// The absorption per mm of a glass that this thickness in mm colours so, Fresnel's losses aside.
[[nodiscard]] Curve read_internal_transmittance(Arguments& arguments);

} // namespace abbe
