#include "core/render.h"

#include "core/lights/lamps.h"
#include "core/tile_renderer.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <immintrin.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <mutex>

namespace abbe {
namespace {

/// Samples of a pixel are rendered in passes, so that a stopped picture is noisy but whole.
constexpr int kSamplesPerPass = 16;

/// Denormal numbers are flushed to zero: they are slow and far below any picture's precision.
class DenormalsOff {
public:
  DenormalsOff() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }
  ~DenormalsOff() { _mm_setcsr(saved_); }
  DenormalsOff(const DenormalsOff&) = delete;
  DenormalsOff& operator=(const DenormalsOff&) = delete;

private:
  unsigned saved_;
};

/// Counts finished tiles and tells about them at most ten times a second.
class ProgressMeter {
public:
  ProgressMeter(const ProgressCallback& callback, std::size_t steps)
      : callback_(callback), steps_(steps) {}

  void step(const RayCounts& rays) {
    const std::lock_guard lock(mutex_);
    ++done_;
    rays_ += rays;
    const double now = seconds();
    if (!callback_ || (now - told_ < 0.1 && done_ < steps_)) return;
    told_ = now;
    callback_({static_cast<double>(done_) / static_cast<double>(steps_), now, rays_});
  }
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  [[nodiscard]] const RayCounts& rays() const { return rays_; }
  [[nodiscard]] bool complete() const { return done_ == steps_; }

private:
  const ProgressCallback& callback_;
  std::size_t steps_, done_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double told_ = 0.0;
  RayCounts rays_;
  std::mutex mutex_;
};

} // namespace

Rendering render(const Scene& scene, const Plan& plan, const World& world, bool keep_bands,
                 const ProgressCallback& progress, const std::atomic<bool>& stop,
                 RayRecord* record) {
  const RenderSettings& settings = plan.settings;
  Rendering result{
      Film(plan.window, plan.quantum, keep_bands ? plan.grid.count() : 0), {}, 0, true};
  const CameraRays camera(scene.camera, settings.width, settings.height);
  const Lamps lamps(scene, plan);
  const Nesting camera_nesting = world.nesting_at(scene.camera.eye);
  const int passes = (settings.samples_per_pixel + kSamplesPerPass - 1) / kSamplesPerPass;
  ProgressMeter meter(progress, static_cast<std::size_t>(passes) * plan.tiles.size());
  assert(!record || settings.threads == 1);
  const int threads = settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);

  for (int pass = 0; pass < passes && !stop; ++pass) {
    const SampleRange samples{pass * kSamplesPerPass,
                              std::min((pass + 1) * kSamplesPerPass, settings.samples_per_pixel)};
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, plan.tiles.size(), 1),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          const DenormalsOff denormals_off;
                          TileRenderer renderer(scene, plan, world, lamps, camera, camera_nesting,
                                                result.film);
                          for (std::size_t i = range.begin(); i < range.end() && !stop; ++i)
                            meter.step(renderer.render(plan.tiles[i], samples, record));
                        });
    });
  }
  result.rays = meter.rays();
  result.seconds = meter.seconds();
  result.complete = meter.complete(); // a stop after the last tile came too late to matter
  return result;
}

} // namespace abbe
