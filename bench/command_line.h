#pragma once

#include "bench/error.h"

namespace abbe::bench {

enum class Measurement { rays, bands, error, done };

/// What the user wants measured. `done`: the command line was answered already.
struct Options {
  Measurement measurement = Measurement::done;
  int exit_code = 0;
  std::vector<std::filesystem::path> scenes;
  ErrorOptions error; ///< `error.render` serves the other measurements too
  std::optional<std::filesystem::path> json;
};

/// Reads the command line. Help and usage errors are printed here.
[[nodiscard]] Options parse_command_line(int argc, const char* const* argv);

} // namespace abbe::bench
