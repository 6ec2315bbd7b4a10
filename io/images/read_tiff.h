#pragma once

#include "io/images/picture.h"

#include <filesystem>

namespace abbe {

/// Reads a TIFF in strips: grey or RGB, of 8 or 16 bits, or of floating-point numbers of 32. Its
/// colour profile is applied; without one, whole numbers are codes of sRGB and others are linear.
/// Throws std::runtime_error for all other TIFFs.
[[nodiscard]] Picture read_tiff_picture(const std::filesystem::path& file,
                                        const PictureRequest& request);

} // namespace abbe
