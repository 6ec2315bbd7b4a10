// An image as a texture:
//
//   imageTexture tiles.png
//
// PNG holds sRGB codes, EXR linear sRGB.

#include "io/images/read_image.h"

#include "io/text/read_arguments.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace abbe {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 26; // 0.8 GB

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

void require_image_size(std::uint64_t width, std::uint64_t height) {
  if (width * height > kMostTexels)
    throw std::runtime_error(
        fmt::format("{} x {} pixels are more than {}", width, height, kMostTexels));
}

ReflectanceImage read_image(const Token& name, const Warn& warn) {
  const fs::path file = image_path(name);
  const bool png = same_name(file.extension().string(), ".png");
  if (!png && !same_name(file.extension().string(), ".exr"))
    throw ReadError(name.where, fmt::format("{} is no image", shown(name)),
                    "its name ends neither in .png nor in .exr",
                    "Give a file of one of these formats");
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "images are found relative to the file that names them",
                    "Check the name, or write the whole path");
  ReflectanceImage image;
  try {
    image = png ? read_png(file) : read_exr(file);
  } catch (const std::exception& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Write the image again, as PNG or EXR");
  }
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
