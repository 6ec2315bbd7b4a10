#include "bench/measurements/plan_skips.h"
#include "core/planning/make_plan.h"

#include "bench/measurements/image_error.h"

#include <algorithm>
#include <array>

namespace abbe::bench {
namespace {

struct NamedSkip {
  const char* name;
  bool Skips::* skip;
};

constexpr std::array kSkips{NamedSkip{"empty tiles", &Skips::empty_tiles},
                            NamedSkip{"dead bands", &Skips::dead_bands},
                            NamedSkip{"constant curves", &Skips::constant_curves},
                            NamedSkip{"constant indices", &Skips::constant_indices}};
static_assert(sizeof(Skips) == kSkips.size() * sizeof(bool), "each skip has a name");

std::vector<double> ratios(const std::vector<double>& of, const std::vector<double>& to) {
  std::vector<double> result;
  for (std::size_t i = 0; i < of.size(); ++i)
    result.push_back(of[i] / to[i]);
  return result;
}

} // namespace

bool SkipCosts::changed() const {
  return std::any_of(costs.begin(), costs.end(),
                     [](const SkipCost& cost) { return cost.changed_pixels > 0; });
}

SkipCosts measure_plan(const std::filesystem::path& scene_path, const RenderOptions& options) {
  const Scene scene = load_scene(scene_path);
  const World world = build_world(scene);
  SkipCosts result{scene.title, settings_for(scene, options), 0, 0, 0, {}};
  const auto add = [&result](const char* without, const Skips& skip) {
    SkipCost cost;
    cost.without = without;
    cost.skip = skip;
    result.costs.push_back(cost);
  };
  add("nothing", Skips(true));
  for (const NamedSkip& named : kSkips) {
    Skips skip(true);
    skip.*named.skip = false;
    add(named.name, skip);
  }
  add("all skips", Skips(false));

  std::vector<Plan> plans;
  std::vector<Film> films;
  for (const SkipCost& cost : result.costs) {
    RenderSettings settings = result.settings;
    settings.skip = cost.skip;
    plans.push_back(make_plan(scene, settings));
    films.push_back(render_once(scene, plans.back(), world, nullptr, true).film);
  }
  const Plan& usual = plans.front();
  result.tiles = usual.tiles.size();
  result.empty_tiles = static_cast<std::size_t>(
      std::count_if(usual.tiles.begin(), usual.tiles.end(), [](const Tile& t) { return t.empty; }));
  result.dead_bands = usual.grid.count() - (usual.live_last - usual.live_first);

  std::vector<std::function<void()>> works;
  for (const Plan& plan : plans)
    works.emplace_back([&] { (void)render_once(scene, plan, world); });
  const std::vector<Runs> runs = interleaved(works, options.repeats, false);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    SkipCost& cost = result.costs[i];
    cost.render_seconds = runs[i].cpu_summary();
    cost.wall_seconds = runs[i].wall_summary();
    cost.ratio = summary(ratios(runs[i].cpu, runs[0].cpu));
    cost.changed_pixels = changed_pixels(films[i], films[0]);
  }
  return result;
}

} // namespace abbe::bench
