#include "bench/measurements/setup.h"

#include "bench/measurements/timing.h"
#include "core/planning/plan_extent.h"
#include "io/scene_files/read_scene_file.h"

#include <algorithm>

namespace abbe::bench {

Scene load_scene(const std::filesystem::path& scene) {
  const bool named = !scene.has_extension() && !scene.has_parent_path();
  const std::filesystem::path path =
      named ? std::filesystem::path(ABBE_SCENES) / (scene.string() + ".sdl") : scene;
  return read_scene_file(path, [](const std::string&) {});
}

std::vector<std::filesystem::path> all_scenes() {
  std::vector<std::filesystem::path> names;
  for (const auto& entry : std::filesystem::directory_iterator(ABBE_SCENES))
    if (entry.path().extension() == ".sdl" && !load_scene(entry.path()).shapes.empty())
      names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

RenderSettings settings_for(const Scene& scene, const RenderOptions& options) {
  RenderSettings settings = scene.settings;
  settings.width = options.width.value_or(settings.width);
  settings.height = options.height.value_or(settings.height);
  settings.bands = options.bands.value_or(settings.bands);
  settings.samples_per_pixel = options.samples_per_pixel.value_or(settings.samples_per_pixel);
  settings.crop = options.crop;
  settings.threads = thread_count(options.threads);
  return settings;
}

World build_world(const Scene& scene) {
  return World(scene.shapes, farthest_coordinate(scene));
}

Rendering render_once(const Scene& scene, const Plan& plan, const World& world, RayRecord* record,
                      bool keep_bands) {
  return render(scene, plan, world,
                keep_bands ? std::optional<BandPlace>(BandPlace{}) : std::nullopt,
                {.record = record});
}

} // namespace abbe::bench
