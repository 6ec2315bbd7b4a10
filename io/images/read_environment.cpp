// What surrounds a scene, as an OpenEXR image of all directions:
//
//   environment sky.exr
//   environment sky.exr D65 0.5

#include "io/images/read_environment.h"

#include "io/images/read_exr.h"
#include "io/images/read_in_child.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

namespace abbe {

Environment read_environment(const Token& name, const Warn& warn) {
  const std::filesystem::path file =
      std::filesystem::path(name.where.file).parent_path() / name.text;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw ReadError(name.where, fmt::format("there is no file \"{}\"", file.string()),
                    "images are found relative to the file that names them",
                    "Check the name, or write the whole path");
  ExrImage image;
  try {
    image = read_in_child([&] { return read_exr_image(file); });
  } catch (const std::exception& fault) {
    throw ReadError(name.where, fmt::format("\"{}\" cannot be read", file.string()), fault.what(),
                    "Write the image again, as OpenEXR");
  }
  if (!image.unknown_tag.empty())
    warn(
        fmt::format("{}: \"{}\" is tagged as \"{}\", which is not known; it is read as linear sRGB",
                    to_string(name.where), file.string(), image.unknown_tag));
  bool negative = false;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    negative = negative || image.rgb[i] < 0.0f;
    if (std::isfinite(image.rgb[i])) continue;
    const std::size_t pixel = i / 3, width = static_cast<std::size_t>(image.width);
    throw ReadError(name.where, fmt::format("\"{}\" has a pixel that is no number", file.string()),
                    fmt::format("the one in column {}, row {}", pixel % width, pixel / width),
                    "Mend the image");
  }
  if (negative)
    warn(fmt::format("{}: \"{}\" has negative components, which count as 0", to_string(name.where),
                     file.string()));
  Environment environment;
  environment.width = image.width;
  environment.height = image.height;
  environment.rgb = std::move(image.rgb);
  return environment;
}

} // namespace abbe
