#include "core/render.h"

#include "core/denormals.h"
#include "core/light_pass.h"
#include "core/lights/lamps.h"
#include "core/noise.h"
#include "core/progress_meter.h"
#include "core/tile_renderer.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <vector>

namespace abbe {
namespace {

/// Samples of a pixel are rendered in passes, so that a stopped picture is noisy but whole.
constexpr int kSamplesPerPass = 16;

/// Where the pass that begins after `done` samples ends. Time that is running out must leave a
/// whole picture, so the first passes are then short.
int end_of_pass(int done, const RenderSettings& settings) {
  const bool hurry = settings.seconds > 0.0 && done < kSamplesPerPass;
  const int pass = hurry ? std::max(done, 1) : kSamplesPerPass;
  return std::min(done + pass, settings.samples_per_pixel);
}

/// True for 16, 32, 64 ... and halfway between, the numbers of samples at which tiles may be done.
/// Asked more often, more tiles would end by luck; docs/decisions/noise.md has figures.
bool may_end(int samples) {
  const auto n = static_cast<unsigned>(samples);
  return n >= kSamplesPerPass &&
         (std::has_single_bit(n) || (n % 3 == 0 && std::has_single_bit(n / 3)));
}

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

} // namespace

Rendering render(const Scene& scene, const Plan& plan, const World& world, bool keep_bands,
                 const ProgressCallback& progress, const std::atomic<bool>& stop,
                 RayRecord* record) {
  const RenderSettings& settings = plan.settings;
  const int most = settings.samples_per_pixel;
  Rendering result{Film(plan.window, plan.quantum, keep_bands ? plan.grid.count() : 0,
                        settings.keep_errors || settings.adaptive())};
  const PlacedCamera camera(scene, settings, world);
  const Lamps lamps(scene, plan);
  LightPasses light_passes(scene, plan, world, camera.pinhole() ? &camera.rays : nullptr,
                           result.film);
  ProgressMeter meter(progress, static_cast<double>(plan.window.pixel_count()) * most,
                      settings.seconds);
  assert(!record || settings.threads == 1);
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);

  std::vector<OpenTile> open;
  for (const Tile& tile : plan.tiles)
    open.push_back({&tile, most});
  const auto ends = [&](int done) {
    return stop || (settings.seconds > 0.0 && done > 0 && meter.seconds() >= settings.seconds);
  };
  // Renders one pass of a tile and decides by its pixels alone whether it is done: the same bytes
  // on any number of threads.
  const auto advance = [&](OpenTile& tile, SampleRange samples, TileRenderer& renderer) {
    const PixelWindow& window = tile.tile->window;
    const auto pixels = static_cast<double>(window.pixel_count());
    const RayCounts rays = renderer.render(*tile.tile, samples, record);
    const int expected = tile.expected;
    tile.expected = std::max(expected, samples.last);
    if (settings.noise > 0.0 && (may_end(samples.last) || samples.last == most)) {
      const double error = relative_error(result.film, window);
      tile.done = error <= settings.noise;
      tile.expected = tile.done ? samples.last : expected_samples(error, samples.last, settings);
    }
    meter.step(rays, pixels * (samples.last - samples.first), pixels * (tile.expected - expected));
  };

  int done = 0, pass = 0;
  while (done < most && !open.empty()) {
    const SampleRange samples{done, end_of_pass(done, settings)};
    std::atomic<std::size_t> rendered = 0;
    arena.execute([&] {
      if (light_passes.needed())
        meter.add(light_passes.run(pass++, samples.last - done, stop, record));
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, open.size(), 1),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          const DenormalsOff denormals_off;
                          TileRenderer renderer(scene, plan, world, lamps,
                                                light_passes.needed() ? &light_passes : nullptr,
                                                camera, result.film);
                          for (std::size_t i = range.begin(); i < range.end() && !ends(done); ++i) {
                            advance(open[i], samples, renderer);
                            ++rendered;
                          }
                        });
    });
    const bool whole = rendered == open.size();
    std::erase_if(open, [](const OpenTile& tile) { return tile.done; });
    if (!whole) break;
    done = samples.last;
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
