#pragma once

#include "core/image/image.h"
#include "io/images/ocio_look.h"
#include "io/images/write_exr.h"
#include "io/images/write_tiff.h"

#include <filesystem>
#include <optional>
#include <string>

namespace abbe {

/// How pixels are stored, for each format that leaves a choice.
struct OutputOptions {
  ExrPixel exr_pixel = ExrPixel::half;
  TiffDepth tiff_depth = TiffDepth::bits8;
  int png_bits = 8; ///< 8 or 16
  SceneLinearSpace exr_space = SceneLinearSpace::rec709;
  ExrTag exr_tag = ExrTag::interop_id;
  IccVersion profile = IccVersion::v4;
  bool layer_files = false;          ///< each layer goes into an EXR of its own
  bool full_frame = false;           ///< crops are written over the whole frame, black around them
  bool denoise = false;              ///< pictures and bands are written without their noise
  std::optional<OcioLook> ocio = {}; ///< makes pictures for screens, in place of our own curves
};

/// True when `write_image` has a writer for the extension of the path, whatever its case.
[[nodiscard]] bool is_known_image_extension(const std::filesystem::path& path);

/// True when `write_image` writes the scene-linear image under this extension, and needs no
/// other.
[[nodiscard]] bool is_scene_linear_extension(const std::filesystem::path& path);

/// ".exr, .tif, .tiff or .png", for messages and help.
[[nodiscard]] std::string known_image_extensions();

/// Writes the image in the format that the extension of the path names: the scene-linear one as
/// EXR, the one for a screen as TIFF or PNG. The file appears under its name when it is complete.
/// Returns what the user should know of it, which is mostly nothing.
/// Errors: `std::runtime_error` for an unknown extension (it lists the known ones) and for all that
/// `replace_file` reports.
std::string write_image(const std::filesystem::path& path, const SceneLinearImage& scene_linear,
                        const DisplayImage& display, const OutputOptions& options);

/// Says that an EXR could not be written in half floats.
[[nodiscard]] std::string note_of_floats(const std::filesystem::path& path);

} // namespace abbe
