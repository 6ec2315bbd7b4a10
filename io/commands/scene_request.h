#pragma once

#include "core/plan/plan.h"
#include "core/scene/scene.h"
#include "io/building/strictness.h"
#include "io/scene_language/input_files.h"
#include "io/settings/setting_text.h"

#include <filesystem>
#include <optional>

namespace abbe {

/// A scene that the command line names, and its settings with those of the command line.
struct SceneRequest {
  Scene scene;
  RenderSettings settings;
  /// Of a relightable rendering the scene with its own lamps; `scene`, which is rendered, is then
  /// the same under light of equal energy.
  std::optional<Scene> with_own_lamps = {};
};

/// The plan of a request under these settings, which may be more than its own. Where they are those
/// of a relightable rendering, the request's scene is brought under light of equal energy.
[[nodiscard]] Plan plan_of(SceneRequest& request, const RenderSettings& settings);

/// Reads and checks it, and tells all warnings on standard error. All files that are read are added
/// to `inputs`, unless it is null.
[[nodiscard]] SceneRequest read_request(const std::filesystem::path& scene_path,
                                        const SettingsOverride& settings, InputFiles* inputs,
                                        Strictness strictness = Strictness::strict);

/// Tells the plan's notes on standard output.
void tell_plan(const Plan& plan);

} // namespace abbe
