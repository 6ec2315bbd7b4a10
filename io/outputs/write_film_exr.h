#pragma once

#include "core/render/render.h"
#include "io/images/write_image.h"
#include "io/outputs/denoised_pictures.h"

#include <filesystem>
#include <string>
#include <vector>

namespace abbe {

/// Writes EXRs of a rendering's film, a few rows at a time, so that no whole picture is in memory.
/// Each function returns what the user should know of the file, which is mostly nothing.
class FilmExrs {
public:
  /// Keeps references. `denoised` makes the picture and the bands, unless it is null.
  FilmExrs(const Film& film, const Plan& plan, const OutputOptions& options,
           const DenoisedPictures* denoised = nullptr);

  /// The names of the layers beside the picture.
  [[nodiscard]] std::vector<std::string> layers() const;

  /// The picture with its layers, unless these have files of their own.
  [[nodiscard]] std::string write_picture(const std::filesystem::path& file) const;
  [[nodiscard]] std::string write_layer(const std::filesystem::path& file,
                                        const std::string& layer) const;
  /// What a band adds to the picture, in 32 bits, so that the sum of all bands is the picture.
  [[nodiscard]] std::string write_band(const std::filesystem::path& file, int band) const;
  /// All bands, and those of a group of lights of a relightable rendering.
  [[nodiscard]] std::string write_bands(const std::filesystem::path& file) const;
  [[nodiscard]] std::string write_unit(const std::filesystem::path& file,
                                       const std::string& group) const;

private:
  [[nodiscard]] PixelWindow data() const;
  [[nodiscard]] ExrHead head() const;
  void write(const std::filesystem::path& file, const ExrHead& head, ExrPixel pixel,
             const LinearRows& develop) const;

  const Film& film_;
  const Plan& plan_;
  const OutputOptions& options_;
  const DenoisedPictures* denoised_;
  Metadata metadata_; ///< found once, not for each block of rows
  ExrPixel pixel_;    ///< of the picture: half floats where that is asked for and they do
};

} // namespace abbe
