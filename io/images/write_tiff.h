#pragma once

#include "core/image/image.h"
#include "io/images/icc_profile.h"

#include <filesystem>

namespace abbe {

/// `bits8`, `bits16`: unsigned integers with the display's transfer function. `float32`: IEEE
/// floats, linear (many programs take a float TIFF for linear whatever its profile says) and
/// neither clipped nor brought into the display's gamut.
enum class TiffDepth { bits8, bits16, float32 };

/// Writes R, G, B with the matching ICC profile, deflated without loss; no alpha, no date, no host.
/// Integers are rounded to nearest, without dithering, NaN to 0; floats are written as they are.
/// The metadata are lines `name: value` of ImageDescription.
///
/// A crop is stored as its data window alone. Where it belongs stands in XPosition and YPosition
/// (pixels, relative to the display window; the resolution is 1 without a unit) and in the tags
/// ImageFullWidth and ImageFullLength; OpenImageIO reads these back as windows.
/// Errors: `std::runtime_error`, see `replace_file`; the old file is kept.
void write_tiff(const std::filesystem::path& path, const DisplayImage& image, TiffDepth depth,
                IccVersion profile = IccVersion::v4);

} // namespace abbe
