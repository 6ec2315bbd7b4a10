// An image as a texture:
//
//   imageTexture tiles.png
//
// PNG holds sRGB codes, EXR linear sRGB or what its tags say.

#include "io/images/read_image.h"

#include "io/files/available_memory.h"
#include "io/images/read_exr.h"
#include "io/images/read_in_child.h"
#include "io/text/read_arguments.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <utility>

namespace abbe {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{2} << 30; // 16384 x 8192 pixels in EXR

/// What lies beyond what a surface can reflect is clamped. Returns false for what is no number.
bool clamp_components(ReflectanceImage& image, bool& clamped) {
  for (float& value : image.rgb) {
    if (!std::isfinite(value)) return false;
    clamped = clamped || value < 0.0f || value > 1.0f;
    value = std::clamp(value, 0.0f, 1.0f);
  }
  return true;
}

} // namespace

fs::path image_path(const Token& name) {
  return fs::path(name.where.file).parent_path() / name.text;
}

void require_image_memory(std::uint64_t width, std::uint64_t height, std::uint64_t pixel_bytes) {
  constexpr double kGiB = 1 << 30;
  const double bytes =
      static_cast<double>(width) * static_cast<double>(height) * static_cast<double>(pixel_bytes);
  if (bytes > static_cast<double>(kMostBytes))
    throw std::runtime_error(
        fmt::format("its {} x {} pixels would take {:.1f} GiB of memory, and {:g} "
                    "GiB is the most for an image",
                    width, height, bytes / kGiB, static_cast<double>(kMostBytes) / kGiB));
  if (const std::uint64_t available = available_memory(); bytes > static_cast<double>(available))
    throw std::runtime_error(
        fmt::format("its {} x {} pixels would take {} of memory, and {} are left", width, height,
                    memory_text(static_cast<std::uint64_t>(bytes)), memory_text(available)));
}

ReflectanceImage read_image(const Token& name, const Warn& warn) {
  const fs::path file = image_path(name);
  const bool png = same_name(file.extension().string(), ".png");
  if (!png && !same_name(file.extension().string(), ".exr"))
    throw ReadError(name.where, fmt::format("{} is no image", shown(name)),
                    "its name ends neither in .png nor in .exr",
                    "Give a file of one of these formats");
  std::error_code error;
  if (!fs::exists(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "images are found relative to the file that names them",
                    "Check the name, or write the whole path");
  ReflectanceImage image;
  std::string unknown_tag;
  try {
    ExrImage read = read_in_child([&]() -> ExrImage {
      if (!png) return read_exr_image(file);
      ReflectanceImage codes = read_png(file);
      return {codes.width, codes.height, std::move(codes.rgb), {}};
    });
    unknown_tag = std::move(read.unknown_tag);
    image = {read.width, read.height, std::move(read.rgb)};
  } catch (const std::exception& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Write the image again, as PNG or EXR");
  }
  if (!unknown_tag.empty())
    warn(
        fmt::format("{}: \"{}\" is tagged as \"{}\", which is not known; it is read as linear sRGB",
                    to_string(name.where), file.string(), unknown_tag));
  bool clamped = false;
  if (!clamp_components(image, clamped))
    throw ReadError(name.where, fmt::format("\"{}\" holds what is no number", file.string()),
                    "a component is infinite or not a number", "Write the image again");
  if (clamped)
    warn(fmt::format("{}: \"{}\" has components below 0 or above 1, which count as 0 and 1",
                     to_string(name.where), file.string()));
  return image;
}

} // namespace abbe
