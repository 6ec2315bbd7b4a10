#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace abbe {

/// Prints the glasses, lights, materials or metals that scenes can name, or all whose names hold a
/// word, or plots one of them.
struct ListCommand {
  static constexpr const char* kName = "list";
  static constexpr const char* kHelp = "List what scenes can name";

  /// glasses, lights, materials or metals, or a part of a name; empty: all, for a plot
  std::string what;
  std::optional<std::filesystem::path> library;
  std::optional<std::string> plot_name; ///< the curve to draw instead of a list
  std::optional<std::filesystem::path> plot_file;
};
void add_options(CLI::App& app, ListCommand& command);
[[nodiscard]] int run(const ListCommand& command);

} // namespace abbe
