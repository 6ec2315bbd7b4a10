#pragma once

#include "bench/measurements/error.h"
#include "bench/measurements/scaling.h"

namespace abbe::bench {

enum class Measurement { rays, bands, error, plan, scaling, compare, done };

/// What the user wants measured. `done`: the command line was answered already.
struct Options {
  Measurement measurement = Measurement::done;
  int exit_code = 0;
  std::vector<std::filesystem::path> scenes;
  ErrorOptions error;
  ScalingOptions scaling;
  RenderOptions render;                       ///< of all measurements; the two above have copies
  std::vector<std::filesystem::path> reports; ///< the two to compare
  double margin = 0.02;                       ///< see `compare`
  std::optional<std::filesystem::path> json, html;
  std::optional<std::filesystem::path> plots; ///< a folder
};

/// Reads the command line. Help and usage errors are printed here.
[[nodiscard]] Options parse_command_line(int argc, const char* const* argv);

} // namespace abbe::bench
