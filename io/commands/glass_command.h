#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Tells what is known of a glass of the catalogue, or of two side by side.
struct GlassCommand {
  static constexpr const char* kName = "glass";
  static constexpr const char* kHelp = "Tell the optical data of a glass, or of two side by side";

  std::vector<std::string> names;                 ///< one or two
  std::optional<std::filesystem::path> catalogue; ///< .agf: its glasses come first
  double step_nm = 20.0;                          ///< of the table
  double thickness_mm = 10.0;                     ///< of what absorbs
  bool csv = false;
};
void add_options(CLI::App& app, GlassCommand& command);
[[nodiscard]] int run(const GlassCommand& command);

} // namespace abbe
