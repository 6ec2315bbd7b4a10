#include "bench/measurements/arithmetic_loop.h"
#include "bench/measurements/memory.h"
#include "bench/measurements/scaling.h"
#include "core/planning/make_plan.h"

#include <algorithm>

namespace abbe::bench {
namespace {

/// Some 0.2 seconds on one thread of a processor of 2026.
constexpr std::uint64_t kLoopSteps = 60'000'000;

/// 1, 2, 4 ... and the last.
std::vector<int> doubled_up_to(int last) {
  std::vector<int> counts;
  for (int n = 1; n < last; n *= 2)
    counts.push_back(n);
  counts.push_back(last);
  return counts;
}

Summary speedups(const std::vector<double>& one, const std::vector<double>& many) {
  std::vector<double> result;
  for (std::size_t i = 0; i < one.size(); ++i)
    result.push_back(one[i] / many[i]);
  return summary(std::move(result));
}

std::optional<std::size_t> film_bytes(const Plan& plan, int bands) {
  const std::size_t before = resident_bytes();
  Film film(plan.window, plan.quantum, bands);
  const std::vector<float> black(static_cast<std::size_t>(bands));
  for_each_pixel(plan.window, [&](int x, int y) { // sums take memory once they are touched
    film.add({x, y, 0, false}, {0.0, 0.0, 0.0}, black);
  });
  return added_bytes(before);
}

std::vector<ImagePoint> measure_pictures(const Scene& scene, const std::vector<RenderSettings>& all,
                                         int repeats) {
  const World world = build_world(scene);
  std::vector<ImagePoint> points;
  std::vector<Plan> plans;
  for (const RenderSettings& settings : all) {
    ImagePoint point;
    point.settings = settings;
    points.push_back(point);
    plans.push_back(make_plan(scene, settings));
  }
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < plans.size(); ++i)
    works.emplace_back(
        [&, i] { points[i].rays = render_once(scene, plans[i], world).rays.total(); });
  const std::vector<Runs> runs = interleaved(works, repeats, true);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    points[i].render_seconds = runs[i].cpu_summary();
    points[i].wall_seconds = runs[i].wall_summary();
    points[i].film_bytes = film_bytes(plans[i], 0);
    points[i].band_film_bytes = film_bytes(plans[i], plans[i].grid.count());
  }
  return points;
}

} // namespace

std::vector<ThreadPoint> measure_threads(const Scene& scene, const RenderSettings& settings,
                                         int repeats) {
  const World world = build_world(scene);
  std::vector<ThreadPoint> points;
  std::vector<Plan> plans;
  for (const int threads : doubled_up_to(settings.threads)) {
    ThreadPoint point;
    point.threads = threads;
    points.push_back(point);
    RenderSettings with_threads = settings;
    with_threads.threads = threads;
    plans.push_back(make_plan(scene, with_threads));
  }
  std::vector<std::function<void()>> works;
  double kept = 0.0; // or the loop's work would be nobody's
  for (std::size_t i = 0; i < plans.size(); ++i) {
    works.emplace_back([&, i] { (void)render_once(scene, plans[i], world); });
    works.emplace_back([&, i] { kept += arithmetic_loop(kLoopSteps, points[i].threads); });
  }
  const std::vector<Runs> runs = interleaved(works, repeats, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Runs &render = runs[2 * i], &loop = runs[2 * i + 1];
    points[i].wall_seconds = render.wall_summary();
    points[i].render_seconds = render.cpu_summary();
    points[i].loop_wall_seconds = loop.wall_summary();
    points[i].speedup = speedups(runs[0].wall, render.wall);
    points[i].loop_speedup = speedups(runs[1].wall, loop.wall);
  }
  return points;
}

std::vector<ImagePoint> measure_sizes(const Scene& scene, const RenderSettings& settings,
                                      int repeats) {
  std::vector<RenderSettings> all;
  for (const int doublings : {-2, -1, 0, 1}) {
    RenderSettings sized = settings;
    const auto scaled = [doublings](int side) {
      return doublings < 0 ? std::max(side >> -doublings, 1) : side << doublings;
    };
    sized.width = scaled(settings.width);
    sized.height = scaled(settings.height);
    sized.crop.reset();
    all.push_back(sized);
  }
  return measure_pictures(scene, all, repeats);
}

std::vector<ImagePoint> measure_samples(const Scene& scene, const RenderSettings& settings,
                                        int repeats) {
  std::vector<RenderSettings> all;
  for (const int samples : {1, 2, 4, 8, 16}) {
    all.push_back(settings);
    all.back().samples_per_pixel = samples;
  }
  return measure_pictures(scene, all, repeats);
}

} // namespace abbe::bench
