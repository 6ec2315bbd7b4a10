#pragma once

#include "io/images/picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abbe {

/// The colours of an OpenEXR file in linear sRGB, interleaved, rows from the top.
struct ExrImage {
  int width = 0, height = 0;
  std::vector<float> rgb;
  /// What the file's tag says, where it is none that we know; the colours are as in the file then.
  std::string unknown_tag;
};

/// Reads channels R, G and B, or Y for grey. Colours whose primaries and white a tag tells (the
/// attribute colorInteropID, or else chromaticities) are taken to those of sRGB, white to white.
/// Throws std::runtime_error: for what is no regular file, for an image that would take more
/// memory than an image may, and for all that OpenEXR finds wrong.
[[nodiscard]] ExrImage read_exr_image(const std::filesystem::path& file);

/// Reads what the file says of its first part, and the part of it that is asked for. Colours are
/// those of `read_exr_image`. Throws std::runtime_error, as above.
[[nodiscard]] Picture read_exr_picture(const std::filesystem::path& file,
                                       const PictureRequest& request);

} // namespace abbe
