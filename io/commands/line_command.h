#pragma once

#include "io/commands/reading_options.h"

namespace abbe {

/// Tells the colours of the pixels on a straight line through a picture.
struct LineCommand {
  static constexpr const char* kName = "line";
  static constexpr const char* kHelp = "Tell the colours and spectra along a line of a picture";

  std::filesystem::path file;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< the first and the last pixel
  ReadingOptions options;
};
void add_options(CLI::App& app, LineCommand& command);
[[nodiscard]] int run(const LineCommand& command);

} // namespace abbe
