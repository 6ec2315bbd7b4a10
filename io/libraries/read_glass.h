#pragma once

#include "core/scene/quantity_limits.h"
#include "io/text/read_arguments.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

namespace abbe {

// What scenes and material libraries say in the same words about the substance of a solid.

inline constexpr Range kIndexRange{"the refractive index", kLeastIndex, kMostIndex};
inline constexpr Range kAbbeRange{"the Abbe number", 1.0, 1e6};
inline constexpr Range kVNumberRange{"a factor on the dispersion of quartz"};
inline constexpr Range kAbsorptionRange{"an absorption per mm", 0.0, 1e9};

/// Reads the name of a glass of the catalogue. Throws ReadError, with similar names, for others.
[[nodiscard]] const Glass& read_glass(Arguments& arguments);

/// The same for a metal of the catalogue.
[[nodiscard]] const Metal& read_metal(Arguments& arguments);

} // namespace abbe
