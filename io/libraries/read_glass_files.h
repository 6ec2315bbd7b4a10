#pragma once

#include "core/scene/material.h"
#include "io/text/token.h"
#include "spectral/glass.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace abbe {

/// A glass of a maker's catalogue, or a substance of refractiveindex.info.
struct FileGlass {
  Glass glass;
  Curve absorption_per_mm = Curve::constant(0.0);
};

/// True for a name that ends as those of refractiveindex.info's files do: .yml or .yaml.
[[nodiscard]] bool is_refractiveindex_file(std::string_view name);

/// All glasses of a catalogue in Zemax's format (.agf), with absorption from its internal
/// transmittances. Glasses whose formula has no index in the visible range are left out with a
/// warning. Throws ReadError.
[[nodiscard]] std::vector<FileGlass>
read_agf_text(std::string_view text, const std::filesystem::path& file, const Warn& warn);

/// n of a file of refractiveindex.info, and k where it has one, over wavelength.
struct RefractiveIndexFile {
  std::optional<Dispersion> n;
  std::optional<Curve> n_table, k;       ///< n as it is tabulated, where it is
  double lower_nm = 0.0, upper_nm = 0.0; ///< the range that n is given for
};
[[nodiscard]] RefractiveIndexFile read_refractiveindex_text(std::string_view text,
                                                            const std::filesystem::path& file);

/// Such a file, which a token names, as a clear glass that absorbs as its k says, or as a metal.
[[nodiscard]] FileGlass read_refractiveindex_glass(const Token& name);
[[nodiscard]] ConductorIndex read_refractiveindex_metal(const Token& name);

} // namespace abbe
