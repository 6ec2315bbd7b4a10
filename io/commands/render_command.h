#pragma once

#include "io/building/strictness.h"
#include "io/commands/state_options.h"
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

struct Peers;

/// Renders a scene into images.
struct RenderCommand {
  static constexpr const char* kName = "render";
  static constexpr const char* kHelp = "Render a scene";

  std::filesystem::path scene_path; ///< may be empty where a state tells it
  Strictness strictness = Strictness::strict;
  SettingsOverride settings;
  DisplayOverride display;
  OutputOptions output;
  std::vector<std::string> given; ///< the names of all options that were given
  /// Empty: NAME.exr and NAME.tiff. Of a part, one state.
  std::vector<std::filesystem::path> outputs;
  std::optional<std::filesystem::path> spectral_output;
  std::optional<double> memory_limit_gib; ///< empty: what the machine has left
  StateOptions states;
  std::optional<std::string> display_server; ///< HOST:PORT of a viewer
  bool quiet = false;
};
void add_options(CLI::App& app, RenderCommand& command);
[[nodiscard]] int run(const RenderCommand& command);
/// The same with peers, of which the first writes all files. Once all is prepared the peers meet,
/// by `Peers::all`; where one of them has met with an error instead, the others return
/// `kPeerFailed`.
[[nodiscard]] int run(const RenderCommand& command, const Peers& peers);
inline constexpr int kPeerFailed = -1;

} // namespace abbe
