#pragma once

#include "core/image/image.h"
#include "io/images/icc_profile.h"

#include <filesystem>

namespace abbe {

/// Writes the encoded R, G, B with 8 or 16 bits each, rounded to nearest, without dithering,
/// NaN to 0; no alpha, no time. Chunks: sRGB (relative colorimetric: the gamut is mapped already)
/// with the gAMA and cHRM that go with it, or, for another display, its profile as iCCP; the
/// metadata as tEXt (iTXt where a value is not ASCII). A crop is stored as its data window, with
/// its place in the display window as the text `abbe/crop`: programs that obey a chunk oFFs show a
/// part of such a picture or none of it. Errors: `std::runtime_error`, see `replace_file`; also
/// for another number of bits. The old file is kept.
void write_png(const std::filesystem::path& path, const DisplayImage& image, int bits = 8,
               IccVersion profile = IccVersion::v4);

} // namespace abbe
