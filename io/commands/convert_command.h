#pragma once

#include "io/building/strictness.h"

#include <filesystem>

namespace CLI {
class App;
}

namespace abbe {

/// Writes a scene of any format that is read in our language, with the files that it needs beside
/// it.
struct ConvertCommand {
  static constexpr const char* kName = "convert";
  static constexpr const char* kHelp = "Write a scene of another program in our language";

  std::filesystem::path scene, output;
  Strictness strictness = Strictness::strict;
};
void add_options(CLI::App& app, ConvertCommand& command);
[[nodiscard]] int run(const ConvertCommand& command);

} // namespace abbe
