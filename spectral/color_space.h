#pragma once

#include "spectral/color.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// An RGB colour space by its primaries and white; the matrix follows by rgb_to_xyz_matrix.
struct ColorSpace {
  std::string name;
  RgbPrimaries primaries;
  Chromaticity white;
  std::string standard; ///< the document that defines it
};

/// The spaces of spectral/data/colourspaces.csv, in its order.
[[nodiscard]] const std::vector<ColorSpace>& color_spaces();

/// The space of this name, in upper or lower case. Empty for an unknown name.
[[nodiscard]] std::optional<ColorSpace> find_color_space(std::string_view name);

} // namespace abbe
