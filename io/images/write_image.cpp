#include "io/images/write_image.h"

#include "core/image/full_frame.h"
#include "io/images/write_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace abbe {
namespace {

/// One row of the table of writers.
struct OutputFormat {
  std::string_view extension; ///< lower case, with its dot
  bool scene_linear;          ///< which of the two images it takes
  std::string (*write)(const std::filesystem::path&, const SceneLinearImage&, const DisplayImage&,
                       const OutputOptions&);
};

std::string write_as_exr(const std::filesystem::path& path, const SceneLinearImage& scene_linear,
                         const DisplayImage&, const OutputOptions& options) {
  const ExrPixel written = write_exr(path, scene_linear, options.exr_pixel, options.exr_tag);
  return written == options.exr_pixel ? "" : note_of_floats(path);
}

std::string write_as_tiff(const std::filesystem::path& path, const SceneLinearImage&,
                          const DisplayImage& display, const OutputOptions& options) {
  write_tiff(path, display, options.tiff_depth, options.profile);
  return "";
}

std::string write_as_png(const std::filesystem::path& path, const SceneLinearImage&,
                         const DisplayImage& display, const OutputOptions& options) {
  write_png(path, display, options.png_bits, options.profile);
  return "";
}

// Each writer goes through replace_file itself, so that none can be called without it.
constexpr std::array kOutputFormats = {
    OutputFormat{".exr", true, write_as_exr},
    OutputFormat{".tif", false, write_as_tiff},
    OutputFormat{".tiff", false, write_as_tiff},
    OutputFormat{".png", false, write_as_png},
};

/// The row for the path, or null. Only ASCII letters have two cases here, in any locale.
const OutputFormat* find_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto row = std::ranges::find(kOutputFormats, extension, &OutputFormat::extension);
  return row == kOutputFormats.end() ? nullptr : &*row;
}

} // namespace

bool is_known_image_extension(const std::filesystem::path& path) {
  return find_format(path) != nullptr;
}

bool is_scene_linear_extension(const std::filesystem::path& path) {
  const OutputFormat* format = find_format(path);
  return format != nullptr && format->scene_linear;
}

std::string known_image_extensions() {
  std::string list;
  for (std::size_t i = 0; i < kOutputFormats.size(); ++i) {
    if (i > 0) list += i + 1 < kOutputFormats.size() ? ", " : " or ";
    list += kOutputFormats[i].extension;
  }
  return list;
}

std::string write_image(const std::filesystem::path& path, const SceneLinearImage& scene_linear,
                        const DisplayImage& display, const OutputOptions& options) {
  const OutputFormat* format = find_format(path);
  if (format == nullptr)
    throw std::runtime_error(fmt::format("cannot write {}: unknown image extension \"{}\" ({} "
                                         "would be right)",
                                         path.string(), path.extension().string(),
                                         known_image_extensions()));
  if (!options.full_frame) return format->write(path, scene_linear, display, options);
  if (format->scene_linear)
    return format->write(path, placed_in(scene_linear.display, scene_linear), display, options);
  return format->write(path, scene_linear, in_full_frame(display), options);
}

std::string note_of_floats(const std::filesystem::path& path) {
  return fmt::format(
      "{}: written with 32 bits a channel, since values are beyond the range of half "
      "floats (65504)",
      path.string());
}

} // namespace abbe
