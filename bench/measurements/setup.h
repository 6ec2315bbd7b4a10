#pragma once

#include "core/plan/plan.h"
#include "core/render/render.h"
#include "geometry/world/world.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace abbe::bench {

/// What all measurements are told; what is not given comes from the measurement or the scene.
struct RenderOptions {
  std::optional<int> width, height, bands, samples_per_pixel;
  std::optional<PixelWindow> crop;
  int threads = 0; ///< 0: one per processor
  int repeats = 5;
};

/// A scene of a file; warnings are dropped, since rendering says them too. A name without folder
/// and extension is one of the project's scenes.
[[nodiscard]] Scene load_scene(const std::filesystem::path& scene);

/// The project's scenes by name, in alphabetical order; files without shapes, which others include,
/// are left out.
[[nodiscard]] std::vector<std::filesystem::path> all_scenes();

/// The scene's settings with the options in their place.
[[nodiscard]] RenderSettings settings_for(const Scene& scene, const RenderOptions& options);

[[nodiscard]] World build_world(const Scene& scene);

[[nodiscard]] Rendering render_once(const Scene& scene, const Plan& plan, const World& world,
                                    RayRecord* record = nullptr, bool keep_bands = false);

} // namespace abbe::bench
