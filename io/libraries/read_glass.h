#pragma once

#include "io/text/read_arguments.h"
#include "spectral/glass.h"
#include "spectral/metal.h"

namespace abbe {

// What scenes and material libraries say in the same words about the substance of a solid.

inline constexpr Range kIndexRange{.meaning = "the refractive index", .open = true};
inline constexpr Range kVNumberRange{"a factor on the dispersion of quartz"};
inline constexpr Range kAbsorptionRange{"an absorption per mm"};

/// Reads the name of a glass of the catalogue. Throws ReadError, with similar names, for others.
[[nodiscard]] const Glass& read_glass(Arguments& arguments);

/// The same for a metal of the catalogue.
[[nodiscard]] const Metal& read_metal(Arguments& arguments);

} // namespace abbe
