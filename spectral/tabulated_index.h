#pragma once

#include <vector>

namespace abbe {

/// n at ascending wavelengths, joined by Steffen's cubics [Ste90]: smooth, exact at the points, and
/// never above or below the two points it lies between, so a table has no dispersion that it does
/// not show. Held at the first and last point beyond them.
struct TabulatedIndex {
  std::vector<double> wavelengths_nm;
  std::vector<double> n;
  std::vector<double> slopes; ///< dn/d(nm) at the points, made by tabulated_index
  friend bool operator==(const TabulatedIndex&, const TabulatedIndex&) = default;
};

/// Throws std::invalid_argument when there is no point, the lengths differ, the wavelengths do not
/// ascend, or a number is not finite.
[[nodiscard]] TabulatedIndex tabulated_index(std::vector<double> wavelengths_nm,
                                             std::vector<double> n);

[[nodiscard]] double refractive_index(const TabulatedIndex& law, double lambda_nm);
[[nodiscard]] bool is_achromatic(const TabulatedIndex& law);

} // namespace abbe
