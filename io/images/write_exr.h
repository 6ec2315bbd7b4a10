#pragma once

#include "core/image/image.h"

#include <filesystem>
#include <functional>

namespace abbe {

/// Type of the channels in the file. `half`: 16 bits, rounded to nearest even. `single`: 32 bits,
/// as computed.
enum class ExrPixel { half, single };

/// Writes channels R, G, B, A with the `colorInteropID` of its space ("lin_rec709_scene"), data
/// window inside display window for a crop, the metadata as string attributes, and the image's
/// further channels in 32 bits (half floats count exactly to 2048 only). An image that has such
/// channels may have no colours: then only those are written. Values are
/// neither clipped nor exposed; NaN and infinity are written as they are. Where a finite value is
/// beyond the range of half floats, R, G, B and A are written as floats. Returns the type that they
/// were written in. Errors: `std::runtime_error`, see `replace_file`; the old file is kept.
ExrPixel write_exr(const std::filesystem::path& path, const SceneLinearImage& image,
                   ExrPixel pixel);

/// Writes all bands in the "OpenEXR Layout for Spectral Images" 1.0: 32-bit channels
/// `S0.<centre>nm` and a preview in R, G, B and A. (source: Fichet2021)
///
/// The preview is not clipped at 0, as the layout's reference writer does: readers of the layout
/// ignore it, and this way it is the same image as `write_exr` gives, true to its
/// `colorInteropID`; a colour outside Rec. 709 stays that colour.
/// `emissiveUnits` is the only string that readers accept; our bands are spectral densities, of the
/// unit that `SpectralImage` names.
/// Errors: as `write_exr`.
///
/// `develop` gives some rows of the image, whose pixels are those of `data`; it is asked for a
/// few rows at a time, so that the whole image's bands are never there at once.
void write_spectral_exr(const std::filesystem::path& path, const PixelWindow& data,
                        const std::function<SpectralImage(const PixelWindow& rows)>& develop);

} // namespace abbe
