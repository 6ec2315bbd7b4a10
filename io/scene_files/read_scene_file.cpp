#include "io/scene_files/read_scene_file.h"

#include "io/gltf/read_gltf.h"
#include "io/pbrt/read_pbrt.h"
#include "io/scene_language/read_scene.h"
#include "spectral/data_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace abbe {
namespace {

/// One row of the table of readers.
struct SceneFormat {
  std::string_view extension; ///< lower case, with its dot
  Scene (*read)(const std::filesystem::path&, const Warn&, InputFiles*, GivenKeywords*, Strictness);
};

Scene read_sdl(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
               GivenKeywords* given, Strictness) {
  return read_scene(file, warn, files, given);
}

Scene read_pbrt_scene(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                      GivenKeywords*, Strictness strictness) {
  return read_pbrt(file, warn, files, strictness);
}

Scene read_gltf_scene(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                      GivenKeywords*, Strictness strictness) {
  return read_gltf(file, warn, files, strictness);
}

constexpr std::array kFormats = {
    SceneFormat{".sdl", read_sdl},
    SceneFormat{".pbrt", read_pbrt_scene},
    SceneFormat{".glb", read_gltf_scene},
    SceneFormat{".gltf", read_gltf_scene},
};

} // namespace

std::string known_scene_extensions() {
  std::string list;
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (i > 0) list += i + 1 < kFormats.size() ? ", " : " or ";
    list += kFormats[i].extension;
  }
  return list;
}

Scene read_scene_file(const std::filesystem::path& file, const Warn& warn, InputFiles* files,
                      GivenKeywords* given, Strictness strictness) {
  const std::string extension = file.extension().string();
  const auto format = std::ranges::find_if(
      kFormats, [&](const SceneFormat& row) { return same_name(row.extension, extension); });
  if (format == kFormats.end())
    throw ReadError(file, "no scene can be read under this name",
                    extension.empty() ? "it has no extension, which tells the format"
                                      : fmt::format("its extension is \"{}\"", extension),
                    "The name should end in " + known_scene_extensions());
  return format->read(file, warn, files, given, strictness);
}

} // namespace abbe
