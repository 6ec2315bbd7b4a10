#include "bench/measurements/rays.h"
#include "core/planning/make_plan.h"

#include <algorithm>

namespace abbe::bench {

const Summary& KindSpeed::best_replay() const {
  return *std::min_element(replay_seconds.begin(), replay_seconds.end(),
                           [](const Summary& a, const Summary& b) { return a.median < b.median; });
}

int KindSpeed::best_width() const {
  if (any_hit) return 1;
  std::size_t best = 0;
  for (std::size_t i = 1; i < replay_seconds.size(); ++i)
    if (replay_seconds[i].median < replay_seconds[best].median) best = i;
  return kPacketWidths[best];
}

double RaySpeed::best_replay_seconds() const {
  double sum = 0.0;
  for (const KindSpeed& kind : kinds)
    sum += kind.best_replay_seconds();
  return sum;
}

double RaySpeed::single_replay_seconds() const {
  double sum = 0.0;
  for (const KindSpeed& kind : kinds)
    sum += kind.replay_seconds.front().median;
  return sum;
}

double RaySpeed::query_seconds() const {
  double sum = 0.0;
  for (const KindSpeed& kind : kinds)
    sum += kind.query_seconds.median;
  return sum;
}

double RaySpeed::ratio() const {
  return best_replay_seconds() / render_seconds.median;
}

RaySpeed measure_rays(const std::filesystem::path& scene_path, const RenderOptions& options) {
  const Scene scene = load_scene(scene_path);
  const RenderSettings settings = settings_for(scene, options);
  const World world = build_world(scene);
  const Plan plan = make_plan(scene, settings);

  RayRecord record;
  RenderSettings one_thread = settings;
  one_thread.threads = 1; // the record is no place for two
  const Rendering recorded = render_once(scene, make_plan(scene, one_thread), world, &record);
  const std::vector<RaysOfKind> kinds = by_kind(record);
  record = {};

  std::vector<std::function<void()>> works{[&] { (void)render_once(scene, plan, world); }};
  for (const RaysOfKind& rays : kinds) {
    for (const int width : kPacketWidths)
      works.emplace_back([&, width] { replay(world, rays, width, settings.threads); });
    works.emplace_back([&] { query(world, rays, settings.threads); });
  }
  const std::vector<Runs> runs = interleaved(works, options.repeats, true);

  RaySpeed result{scene.title, settings, runs[0].cpu_summary(), runs[0].wall_summary(), {}, {}};
  result.counts = recorded.rays;
  std::size_t next = 1;
  for (const RaysOfKind& rays : kinds) {
    KindSpeed speed{rays.kind, rays.states.size(), {}, {}, rays.any_hit};
    for (Summary& seconds : speed.replay_seconds)
      seconds = runs[next++].cpu_summary();
    speed.query_seconds = runs[next++].cpu_summary();
    result.kinds.push_back(speed);
  }
  return result;
}

} // namespace abbe::bench
