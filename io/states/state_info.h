#pragma once

#include "core/adaptive/render_part.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abbe {

/// A file that a scene was read from, by its content.
struct SceneFile {
  std::filesystem::path path;
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;
};
/// Errors: std::runtime_error, for a file that cannot be read any more.
[[nodiscard]] std::vector<SceneFile> scene_files(std::span<const std::filesystem::path> files);

/// The settings on which the bytes of a picture depend, but for the number of samples: as options
/// of the command line and their values.
using KeptSettings = std::vector<std::pair<std::string, std::string>>;

/// What a state is the state of.
struct StateInfo {
  std::string version;     ///< of the program
  std::uint32_t build = 0; ///< the checksum of the program's own file
  std::filesystem::path scene;
  std::vector<SceneFile> files; ///< the scene's own, and all that it names
  KeptSettings settings;
  int samples = 0; ///< a pixel's, in all
  RenderPart part;
};

/// True where samples are spread by a plan that was made before (`kPlanOption` tells which).
inline constexpr const char* kPlanOption = "--plan-in";
[[nodiscard]] bool is_planned(const StateInfo& info);

/// This program's version, and the checksum of its own file; 0 where it cannot be read.
[[nodiscard]] std::string program_version();
[[nodiscard]] std::uint32_t build_checksum();

} // namespace abbe
