#pragma once

#include "io/images/write_image.h"
#include "io/settings/setting_text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abbe {

enum class Command { render, plan, list, done };

/// What the user asks for. `done`: the command line itself was answered (help, version, a mistake)
/// and `exit_code` is all that is left to return.
struct Options {
  Command command = Command::done;
  int exit_code = 0;
  std::filesystem::path scene_path;
  SettingsOverride settings;
  DisplayOverride display;
  OutputOptions output;
  std::vector<std::string> given;             ///< the names of all options that were given
  std::vector<std::filesystem::path> outputs; ///< empty: NAME.exr and NAME.tiff
  std::optional<std::filesystem::path> spectral_output;
  std::optional<double> memory_limit_gib; ///< empty: what the machine has left
  bool quiet = false;
  std::string list_what; ///< glasses, lights, materials or metals; empty: all, for a plot
  std::optional<std::filesystem::path> list_library;
  std::optional<std::string> plot_name; ///< the curve to draw instead of a list
  std::optional<std::filesystem::path> plot_file;
};

/// Exit codes: a mistake of the user's is 2, any other failure 1, an interruption 130.
inline constexpr int kExitFailure = 1, kExitUsage = 2, kExitInterrupted = 130;

/// Reads the command line. Help, version and usage errors are printed here.
[[nodiscard]] Options parse_command_line(int argc, const char* const* argv);

} // namespace abbe
