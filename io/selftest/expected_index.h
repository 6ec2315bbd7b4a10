#pragma once

#include <array>
#include <string_view>

namespace abbe {

/// The lines F, d and C, at which makers of glass give its index.
inline constexpr std::array<double, 3> kGlassLines_nm{486.1327, 587.5618, 656.2725};

/// A glass's index at these lines, as expected: from spectral/data/expected/glass_lines.csv, and
/// not from the catalogue's formula. Throws std::out_of_range for a glass that is not there.
[[nodiscard]] std::array<double, 3> expected_index(std::string_view glass);

/// What the catalogue of this build gives. Throws std::out_of_range for an unknown glass.
[[nodiscard]] double catalogue_index(std::string_view glass, double lambda_nm);

} // namespace abbe
