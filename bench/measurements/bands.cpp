#include "bench/measurements/bands.h"
#include "core/planning/make_plan.h"

#include <array>

namespace abbe::bench {

BandCosts measure_bands(const std::filesystem::path& scene_path, const RenderOptions& options) {
  constexpr std::array kLevels{1, 3, 9, 27, 81};
  const Scene scene = load_scene(scene_path);
  const World world = build_world(scene);
  BandCosts result{scene.title, settings_for(scene, options), {}};
  std::vector<Plan> plans;
  for (const int bands : kLevels) {
    result.settings.bands = bands;
    plans.push_back(make_plan(scene, result.settings));
    result.costs.push_back({bands, {}, {}, {}});
  }
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < plans.size(); ++i)
    works.emplace_back(
        [&, i] { result.costs[i].counts = render_once(scene, plans[i], world).rays; });
  const std::vector<Runs> runs = interleaved(works, options.repeats, true);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    result.costs[i].render_seconds = runs[i].cpu_summary();
    result.costs[i].wall_seconds = runs[i].wall_summary();
  }
  return result;
}

} // namespace abbe::bench
