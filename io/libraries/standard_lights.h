#pragma once

#include "io/text/token.h"
#include "spectral/curve.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// The light that is always there under this name: a CIE illuminant, `sodium`, blackbody(KELVIN),
/// daylight(KELVIN) or line(NM). Each has Y = 1. Empty for other names.
/// Throws ReadError for a number that does not fit.
[[nodiscard]] std::optional<Curve> standard_light(const Token& name);

/// True when there is a standard light of this name.
[[nodiscard]] bool is_standard_light(std::string_view name);

/// The names of them, with an example for those that take a number.
[[nodiscard]] std::vector<std::string> standard_light_names();

} // namespace abbe
