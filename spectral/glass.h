#pragma once

#include "spectral/dispersion.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A named optical material.
struct Glass {
  std::string name;
  Dispersion dispersion;
  double lower_nm = 0.0; ///< the range for which the law was fitted
  double upper_nm = 0.0;
  std::string source;           ///< reference of the coefficients
  std::optional<double> n_d;    ///< as published, not as computed from the law
  std::optional<double> v_d;    ///< as published
  std::string published_source; ///< where n_d and v_d were read
};

/// The built-in materials, in the order of spectral/data/glass.csv [Pol24]. Indices are relative to
/// what the maker says: Schott's to air, `water-20C` and `air-15C` to vacuum.
[[nodiscard]] const std::vector<Glass>& glass_catalogue();

/// The built-in material of this name, in upper or lower case; null when there is none. It lives as
/// long as the program.
[[nodiscard]] const Glass* find_glass(std::string_view name);

} // namespace abbe
