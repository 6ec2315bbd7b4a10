#include "core/render/render.h"

#include "core/adaptive/noise.h"
#include "core/adaptive/sample_allocation.h"
#include "core/adaptive/sample_schedule.h"
#include "core/bundles/denormals.h"
#include "core/integrators/light_pass.h"
#include "core/lights/lights.h"
#include "core/render/progress_meter.h"
#include "core/render/tile_renderer.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace abbe {
namespace {

/// A tile that is not done yet.
struct OpenTile {
  const Tile* tile;
  int expected; ///< how many samples a pixel it may need
  bool done = false;
};

/// How many samples a tile may need, by the error it has after n of them: errors fall like
/// 1/sqrt(n).
int expected_samples(double error, int n, const RenderSettings& settings) {
  const double expected = n * std::pow(error / settings.noise, 2);
  const double most = settings.samples_per_pixel;
  return static_cast<int>(std::min(std::max(expected, n + 1.0), most));
}

/// By how many samples an allocation misses `mean` samples a pixel.
double more_than(const std::vector<std::uint32_t>& allocation, int mean) {
  const auto total = std::accumulate(allocation.begin(), allocation.end(), std::uint64_t{0});
  return static_cast<double>(total) -
         static_cast<double>(mean) * static_cast<double>(allocation.size());
}

} // namespace

Rendering render(const Scene& scene, const Plan& plan, const World& world, const KeepBands& bands,
                 const ProgressCallback& progress, const std::atomic<bool>& stop,
                 RayRecord* record) {
  const RenderSettings& settings = plan.settings;
  const SampleSchedule schedule(settings);
  const int most = settings.samples_per_pixel;
  Rendering result{Film(plan.window, plan.quantum, bands.keep ? plan.grid.count() : 0,
                        settings.needs_errors(), bands.place)};
  const PlacedCamera camera(scene, settings, world);
  const Lights lights(scene, plan);
  LightPasses light_passes(scene, plan, world, camera.connects() ? &camera : nullptr, result.film);
  ProgressMeter meter(progress, static_cast<double>(plan.window.pixel_count()) * most,
                      settings.seconds);
  assert(!record || settings.threads == 1);
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);

  std::vector<std::uint32_t> pixel_rays; // row by row, where adaptive sampling asks for them
  if (settings.adaptive == AdaptiveSampling::on) pixel_rays.resize(plan.window.pixel_count());
  std::vector<OpenTile> open;
  for (const Tile& tile : plan.tiles)
    open.push_back({&tile, most});
  const auto ends = [&](int done) {
    return stop || (settings.seconds > 0.0 && done > 0 && meter.seconds() >= settings.seconds);
  };
  // Renders one pass of a tile and decides by its pixels alone whether it is done: the same bytes
  // on any number of threads.
  const auto advance = [&](OpenTile& tile, const PassSamples& samples, int last,
                           TileRenderer& renderer) {
    const PixelWindow& window = tile.tile->window;
    const auto pixels = static_cast<double>(window.pixel_count());
    std::uint64_t done = 0;
    const RayCounts rays = renderer.render(*tile.tile, samples, record, done);
    if (done > 0) result.film.touched_bands(window.pixel_count());
    const int expected = tile.expected;
    tile.expected = std::max(expected, last);
    if (settings.noise > 0.0 && (schedule.may_end(last) || last == most)) {
      const double error = relative_error(result.film, window);
      tile.done = error <= settings.noise;
      tile.expected = tile.done ? last : expected_samples(error, last, settings);
    }
    meter.step(rays, static_cast<double>(done), pixels * (tile.expected - expected));
  };

  int done = 0, round_end = schedule.end_of_round(0);
  int light_pass = 0, light_done = 0;    // there are light paths for so many samples
  std::vector<std::uint32_t> allocation; // empty: all pixels get the same
  while (done < most && !open.empty()) {
    if (done == round_end) {
      round_end = schedule.end_of_round(done);
      arena.execute([&] { allocation = allocate_samples(result.film, pixel_rays, round_end); });
      if (round_end == most) meter.step({}, 0.0, more_than(allocation, most));
    }
    const int last = schedule.end_of_pass(done, round_end);
    const PassSamples samples = allocation.empty()
                                    ? PassSamples({done, last})
                                    : PassSamples(allocation, schedule.passes(done, round_end));
    std::atomic<std::size_t> rendered = 0;
    arena.execute([&] {
      if (light_passes.needed() && done >= light_done) {
        light_done = schedule.end_of_light_pass(done, last);
        meter.add(light_passes.run(light_pass++, light_done - done, stop, record));
      }
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, open.size(), 1),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          const DenormalsOff denormals_off;
                          TileRenderer renderer(scene, plan, world, lights,
                                                light_passes.needed() ? &light_passes : nullptr,
                                                camera, result.film, pixel_rays);
                          for (std::size_t i = range.begin(); i < range.end() && !ends(done); ++i) {
                            advance(open[i], samples, last, renderer);
                            ++rendered;
                          }
                        });
    });
    const bool whole = rendered == open.size();
    std::erase_if(open, [](const OpenTile& tile) { return tile.done; });
    if (!whole) break;
    done = last;
  }
  result.rays = meter.rays();
  result.seconds = meter.seconds();
  result.light_seconds = light_passes.seconds();
  result.open_tiles = settings.noise > 0.0 ? open.size() : 0;
  // A stop after the last tile came too late to matter.
  result.complete = done == most || open.empty() || !stop;
  return result;
}

} // namespace abbe
