#pragma once

#include "io/commands/reading_options.h"

namespace abbe {

/// Tells the mean colour and spectrum of a part of a picture, and how its pixels deviate from them.
struct RegionCommand {
  static constexpr const char* kName = "region";
  static constexpr const char* kHelp = "Tell the mean colour and spectrum of a part of a picture";

  std::filesystem::path file;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< as a crop: without column x1 and row y1
  ReadingOptions options;
};
void add_options(CLI::App& app, RegionCommand& command);
[[nodiscard]] int run(const RegionCommand& command);

} // namespace abbe
