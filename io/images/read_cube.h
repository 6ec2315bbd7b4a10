#pragma once

#include "core/image/image.h"

#include <filesystem>
#include <functional>
#include <span>

namespace abbe {

/// The bands of a group of lights, as a relightable rendering writes them.
struct CubeHeader {
  PixelWindow display, data;
  int bands = 0;
  Metadata metadata; ///< its texts by their names
};

/// A pixel's bands in ascending order, and its alpha.
using UseCubePixel = std::function<void(std::span<const float> bands, float alpha)>;

/// Reads an EXR of the spectral layout whose bands are those of a BandGrid. `begin` gets its header
/// before the first pixel; `use` gets the pixels row by row, from the top. Errors:
/// std::runtime_error, which names the file and says what is wrong.
void read_cube(const std::filesystem::path& file,
               const std::function<void(const CubeHeader&)>& begin, const UseCubePixel& use);

} // namespace abbe
