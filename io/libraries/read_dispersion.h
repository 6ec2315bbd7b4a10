#pragma once

#include "io/text/read_arguments.h"
#include "spectral/dispersion.h"

#include <optional>

namespace abbe {

// What scenes and material libraries say in the same words about a refractive index.

inline constexpr Range kDispersionScaleRange{"a factor on the dispersion"};

inline constexpr std::string_view kCauchyUsage = "cauchy A B C";
inline constexpr std::string_view kAbbeUsage = "abbe nd Vd";
inline constexpr std::string_view kIndexTableUsage = "indexTable COUNT nm n ...";
inline constexpr std::string_view kIndexFitUsage = "indexFit COUNT nm n ...";
inline constexpr std::string_view kQuartzUsage = "quartz linear|polynomial";
inline constexpr std::string_view kDispersionScaleUsage = "dispersionScale x";

/// An index that is written out, and what to call it.
struct WrittenIndex {
  Dispersion law;
  std::string name;
};

/// A glass by the six digits of its code, as the lists of makers give it, if that is what follows:
/// 603606 has n_d 1.603 and V_d 60.6. Codes that begin with less than 200 are those of indices
/// above 2. A density may follow a point: 517642.251.
[[nodiscard]] std::optional<WrittenIndex> read_glass_code(Arguments& arguments);

/// n_d and V_d, two numbers. Throws ReadError where no medium can have them.
[[nodiscard]] Dispersion read_abbe_numbers(Arguments& arguments);

/// Cauchy's A, B (um^2) and C (um^4).
[[nodiscard]] WrittenIndex read_cauchy(Arguments& arguments, const Warn& warn);
/// n_d and the Abbe number.
[[nodiscard]] WrittenIndex read_abbe(Arguments& arguments, const Warn& warn);
/// The number of points, then wavelength (nm) and n of each. Warns where pictures need more.
[[nodiscard]] WrittenIndex read_index_table(Arguments& arguments, const Warn& warn);
/// The same points, fitted; the name tells the largest residual. Warns when it is above 1e-4.
[[nodiscard]] WrittenIndex read_index_fit(Arguments& arguments, const Warn& warn);
/// The thesis's line or its quintic.
[[nodiscard]] WrittenIndex read_quartz(Arguments& arguments, const Warn& warn);

/// Points of a curve over wavelength: their number, then nm, ascending, and value of each.
struct Points {
  std::vector<double> nm, values;
};
[[nodiscard]] Points read_points(Arguments& arguments, const Range& value);

} // namespace abbe
