#pragma once

#include "io/building/strictness.h"
#include "io/settings/setting_text.h"

#include <filesystem>

namespace CLI {
class App;
}

namespace abbe {

/// Tells what a scene needs and what is left out, and renders nothing.
struct PlanCommand {
  static constexpr const char* kName = "plan";
  static constexpr const char* kHelp = "Tell what a scene needs and what is left out";

  std::filesystem::path scene_path;
  Strictness strictness = Strictness::strict;
  SettingsOverride settings;
};
void add_options(CLI::App& app, PlanCommand& command);
[[nodiscard]] int run(const PlanCommand& command);

} // namespace abbe
