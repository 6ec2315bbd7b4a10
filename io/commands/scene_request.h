#pragma once

#include "core/plan/plan.h"
#include "core/scene/scene.h"
#include "io/pbrt/strictness.h"
#include "io/scene_language/input_files.h"
#include "io/settings/setting_text.h"

#include <filesystem>

namespace abbe {

/// A scene that the command line names, and its settings with those of the command line.
struct SceneRequest {
  Scene scene;
  RenderSettings settings;
};

/// Reads and checks it, and tells all warnings on standard error. All files that are read are added
/// to `inputs`, unless it is null.
[[nodiscard]] SceneRequest read_request(const std::filesystem::path& scene_path,
                                        const SettingsOverride& settings, InputFiles* inputs,
                                        Strictness strictness = Strictness::strict);

/// Tells the plan's notes on standard output.
void tell_plan(const Plan& plan);

} // namespace abbe
