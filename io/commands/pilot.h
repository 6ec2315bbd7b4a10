#pragma once

#include "core/plan/plan.h"
#include "core/scene/scene.h"
#include "io/scene_language/input_files.h"
#include "io/states/state_info.h"

#include <atomic>
#include <filesystem>

namespace abbe {

// Plans of where samples go: docs/farm.md.

/// Renders a few samples a pixel, by which it plans where those of the picture shall go, and writes
/// that. They are no samples of the picture, whose random numbers are others. False when it was
/// stopped.
[[nodiscard]] bool write_pilot(const std::filesystem::path& file, const Scene& scene,
                               const Plan& plan, const StateInfo& info,
                               const std::atomic<bool>& stop, bool quiet);

/// A plan that fits the scene, and what tells it from others.
struct Spread {
  std::vector<float> shares;
  KeptSettings::value_type setting;
};
/// Throws UserError for a plan of another scene or of other settings.
[[nodiscard]] Spread read_spread(const std::filesystem::path& file, const Plan& plan,
                                 const InputFiles& inputs);

} // namespace abbe
