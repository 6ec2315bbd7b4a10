#pragma once

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Writes a page that shows pictures in a browser.
struct ViewCommand {
  static constexpr const char* kName = "view";
  static constexpr const char* kHelp =
      "Write an HTML page that shows pictures, their colours and spectra";

  std::vector<std::filesystem::path> files; ///< pictures, and folders of pictures
  std::filesystem::path page;               ///< empty: the first name, with .html
};
void add_options(CLI::App& app, ViewCommand& command);
[[nodiscard]] int run(const ViewCommand& command);

} // namespace abbe
