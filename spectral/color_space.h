#pragma once

#include "spectral/color.h"
#include "spectral/transfer.h"

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
  std::string standard;                 ///< the document that defines it
  std::vector<std::string> short_names; ///< what commands and scenes call it
  TransferFunction transfer;            ///< the transfer function, unless another is chosen
  friend bool operator==(const ColorSpace&, const ColorSpace&) = default;
};

/// The spaces of spectral/data/colourspaces.csv, in its order.
[[nodiscard]] const std::vector<ColorSpace>& color_spaces();

/// The space of this name or short name, in upper or lower case. Empty for an unknown name.
[[nodiscard]] std::optional<ColorSpace> find_color_space(std::string_view name);

/// The short names, in the table's order.
[[nodiscard]] std::vector<std::string> color_space_names();

/// The space of ordinary screens.
[[nodiscard]] const ColorSpace& srgb_space();

} // namespace abbe
