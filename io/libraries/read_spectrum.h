#pragma once

#include "io/text/token.h"
#include "spectral/curve.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace abbe {

/// A spectrum as an instrument or a table gives it: values at wavelengths of any step and range.
struct MeasuredSpectrum {
  std::vector<double> nm; ///< ascending
  std::vector<double> values;
  std::vector<std::size_t> lines; ///< where in the file each of them stands
};

/// True for a name that ends as those of files with a spectrum do.
[[nodiscard]] bool is_spectrum_file(std::string_view name);

/// Reads a table (.csv, .tsv, .txt), a CGATS file (.sp, .cgats, as Argyll writes it) or the XML of
/// IES TM-27 (.spdx). Throws ReadError.
[[nodiscard]] MeasuredSpectrum
read_spectrum_text(std::string_view text, const std::filesystem::path& file, const Warn& warn);

/// The light of a file that `name` names, found from the folder of the file that names it: linear
/// between its points, held beyond them, and scaled so that Y = 1. Values below 0 count as 0, with
/// a warning. Throws ReadError.
[[nodiscard]] Curve read_lamp(const Token& name, const Warn& warn);

/// The same for a reflectance, as means over 5 nm around 380, 385 ... 780 nm. Values above 1, up
/// to 1.05, count as 1 with a warning.
[[nodiscard]] Curve read_reflectance(const Token& name, const Warn& warn);

} // namespace abbe
