#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abbe {

/// Takes the noise out of a picture that is there already, and out of its bands.
struct DenoiseCommand {
  static constexpr const char* kName = "denoise";
  static constexpr const char* kHelp = "Take the noise out of a picture with the layers for it";

  std::filesystem::path file, output;
  std::vector<std::filesystem::path> spectral; ///< the EXR of all bands, and what becomes of it
  bool quiet = false;
};
void add_options(CLI::App& app, DenoiseCommand& command);
[[nodiscard]] int run(const DenoiseCommand& command);

} // namespace abbe
