#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace abbe {

/// Tells what a file holds that the program has written.
struct InfoCommand {
  static constexpr const char* kName = "info";
  static constexpr const char* kHelp = "Tell what a picture, or the state of a rendering, holds";

  std::filesystem::path file;
};
void add_options(CLI::App& app, InfoCommand& command);
[[nodiscard]] int run(const InfoCommand& command);

} // namespace abbe
