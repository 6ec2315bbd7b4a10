#pragma once

#include "io/commands/reading_options.h"

namespace abbe {

/// What a difference is measured by, where it decides the exit code.
enum class DifferenceMeasure { rmse, rel_mse, mean_delta_e, delta_e_95 };

/// Compares two pictures.
struct DiffCommand {
  static constexpr const char* kName = "diff";
  static constexpr const char* kHelp = "Compare a picture with another one";

  std::filesystem::path picture, reference;
  std::optional<double> tolerance; ///< beyond which the exit code is 1
  DifferenceMeasure measure = DifferenceMeasure::rmse;
  std::optional<std::filesystem::path> output; ///< of the picture in false colours
  double most = 10.0;                          ///< the difference that is shown as yellow
  bool bands = false;                          ///< a table of all bands
  ReadingOptions options;
};
void add_options(CLI::App& app, DiffCommand& command);
[[nodiscard]] int run(const DiffCommand& command);

} // namespace abbe
