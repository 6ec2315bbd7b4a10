#pragma once

#include "io/images/write_image.h"
#include "io/settings/setting_text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Merges the parts of a rendering (`render --part`) into images.
struct MergeCommand {
  static constexpr const char* kName = "merge";
  static constexpr const char* kHelp = "Merge the parts of a rendering into pictures";

  std::vector<std::filesystem::path> parts;
  std::optional<std::filesystem::path> scene_path; ///< empty: as the first part tells
  DisplayOverride display;
  OutputOptions output;
  std::vector<std::string> given;             ///< the names of all options that were given
  std::vector<std::filesystem::path> outputs; ///< at least one
  std::optional<std::filesystem::path> spectral_output;
  bool quiet = false;
};
void add_options(CLI::App& app, MergeCommand& command);
[[nodiscard]] int run(const MergeCommand& command);

} // namespace abbe
