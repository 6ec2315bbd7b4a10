#pragma once

#include "core/image/image.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace abbe {

/// Type of the channels in the file. `half`: 16 bits, rounded to nearest even. `single`: 32 bits,
/// as computed.
enum class ExrPixel { half, single };

/// How a file says which colours its values are.
enum class ExrTag {
  interop_id,     ///< by `colorInteropID` alone, as is recommended (source: ColorInterop2026)
  chromaticities, ///< by `chromaticities`, which older programs know
  both,
  none,
};

/// What `colorInteropID` calls a space. (source: ColorInterop2026)
[[nodiscard]] const char* interop_id(SceneLinearSpace space);

/// What stands in the file's header.
struct ExrHead {
  PixelWindow display, data;
  Metadata metadata = {};
  SceneLinearSpace space = SceneLinearSpace::rec709;
  std::optional<CameraMatrices> camera = {};
  ExrTag tag = ExrTag::interop_id;
};

/// Gives some rows of a picture whose data window is as wide as these.
using LinearRows = std::function<SceneLinearImage(const PixelWindow& rows)>;

/// Writes channels R, G, B, A with the tag of their space, data window inside display window for a
/// crop, the metadata as string attributes, the camera as `worldToCamera` and `worldToNDC`, and the
/// image's further channels in 32 bits (half floats count exactly to 2048 only). An image that has
/// such channels may have no colours: then only those are written. Values are neither clipped nor
/// exposed; NaN and infinity are written as they are. Where a finite value is beyond the range of
/// half floats, R, G, B and A are written as floats. Returns the type that they were written in.
/// Errors: `std::runtime_error`, see `replace_file`; the old file is kept.
ExrPixel write_exr(const std::filesystem::path& path, const SceneLinearImage& image, ExrPixel pixel,
                   ExrTag tag = ExrTag::interop_id);

/// The same of a picture that is made while it is written, a few rows at a time. The values must
/// fit into `pixel`.
void write_exr_rows(const std::filesystem::path& path, const ExrHead& head, ExrPixel pixel,
                    const LinearRows& develop);

/// True when each finite value is finite as a half, too.
[[nodiscard]] bool fits_half(std::span<const float> values);

/// Writes all bands in the "OpenEXR Layout for Spectral Images" 1.0: channels `S0.<centre>nm` and a
/// preview in R, G, B and A, all in 32 bits. (source: Fichet2021)
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
                        const std::function<SpectralImage(const PixelWindow& rows)>& develop,
                        ExrTag tag = ExrTag::interop_id);

} // namespace abbe
