#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace abbe {

/// Tells the first-order data of a camera lens, its colour errors and its spots.
struct LensCommand {
  static constexpr const char* kName = "lens";
  static constexpr const char* kHelp = "Tell the focal length, colour errors and spots of a lens";

  std::filesystem::path file;
  double field_deg = 0.0; ///< of the spots: the angle of parallel light to the axis
  bool json = false;
};
void add_options(CLI::App& app, LensCommand& command);
[[nodiscard]] int run(const LensCommand& command);

} // namespace abbe
