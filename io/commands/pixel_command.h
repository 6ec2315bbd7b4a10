#pragma once

#include "io/commands/reading_options.h"

namespace abbe {

/// Tells the colour and the spectrum of a pixel of a picture.
struct PixelCommand {
  static constexpr const char* kName = "pixel";
  static constexpr const char* kHelp = "Tell the colour and the spectrum of a pixel";

  std::filesystem::path file;
  int x = 0, y = 0;
  std::vector<int> to; ///< another pixel to compare with; empty or two numbers
  std::optional<std::filesystem::path> plot_file;
  ReadingOptions options;
};
void add_options(CLI::App& app, PixelCommand& command);
[[nodiscard]] int run(const PixelCommand& command);

} // namespace abbe
