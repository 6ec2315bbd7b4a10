#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Changes the lamps of a relightable rendering without tracing a ray.
struct RelightCommand {
  static constexpr const char* kName = "relight";
  static constexpr const char* kHelp = "Change the lamps of a relightable rendering";

  std::vector<std::filesystem::path> cubes;
  std::vector<std::string> lights;                    ///< NAME=LAMP or NAME=LAMP,STRENGTH
  std::optional<std::filesystem::path> light_library; ///< where lamps are looked up, too
  std::filesystem::path output;
  bool quiet = false;
};
void add_options(CLI::App& app, RelightCommand& command);
[[nodiscard]] int run(const RelightCommand& command);

} // namespace abbe
