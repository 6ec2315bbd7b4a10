#include "core/render.h"

#include "core/camera.h"
#include "core/integrators/path.h"
#include "core/integrators/whitted.h"
#include "core/light_pass.h"
#include "core/lights/lamps.h"
#include "core/sampler.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <memory>
#include <mutex>

namespace abbe {
namespace {

/// Samples of a pixel are rendered in passes, so that a stopped picture is noisy but whole.
constexpr int kSamplesPerPass = 16;
constexpr std::size_t kPacketWidth = 16;

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

std::unique_ptr<CameraIntegrator> make_integrator(const Scene& scene, const Plan& plan,
                                                  const World& world, const Lamps& lamps,
                                                  const LightPasses* light_passes,
                                                  double pixel_angle) {
  if (plan.settings.integrator == Integrator::path)
    return std::make_unique<Path>(plan, world, lamps, light_passes, pixel_angle);
  return std::make_unique<Whitted>(scene, plan, world, pixel_angle);
}

/// Which samples of each pixel are to be rendered: [first, last).
struct SampleRange {
  int first, last;
};

/// Renders tiles on one thread.
class TileRenderer {
public:
  TileRenderer(const Scene& scene, const Plan& plan, const World& world, const Lamps& lamps,
               const LightPasses* light_passes, const CameraRays& camera,
               const Nesting& camera_nesting, Film& film)
      : plan_(plan), world_(world), camera_(camera), camera_nesting_(camera_nesting), film_(film),
        integrator_(make_integrator(scene, plan, world, lamps, light_passes, camera.pixel_angle())),
        sums_(plan) {}

  RayCounts render(const Tile& tile, SampleRange samples, RayRecord* record) {
    RayCounts counts;
    counts.record = record;
    const PixelWindow& w = tile.window;
    for (int y = w.y0; y < w.y1; ++y)
      for (int x = w.x0; x < w.x1; ++x)
        for (int s = samples.first; s < samples.last; ++s) {
          batch_.push_back(
              {x, y, Sampler(x, y, static_cast<std::uint32_t>(s), plan_.settings.seed)});
          if (batch_.size() == kPacketWidth) finish_batch(tile.empty, counts);
        }
    finish_batch(tile.empty, counts);
    return counts;
  }

private:
  struct CameraSample {
    int x, y;
    Sampler sampler;
  };

  void finish_batch(bool empty, RayCounts& counts) {
    const std::size_t count = batch_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const CameraSample& sample = batch_[i];
      const dvec2 offset =
          filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
      states_[i].ray = camera_.ray(dvec2(sample.x + 0.5, sample.y + 0.5) + offset);
      states_[i].nesting = camera_nesting_;
      hits_[i].reset();
    }
    if (!empty) {
      world_.closest(std::span(states_).first(count), std::span(hits_).first(count),
                     plan_.settings.tracing);
      counts.add(RayKind::camera, std::span(states_).first(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
      sums_.clear();
      integrator_->trace(states_[i], hits_[i], batch_[i].sampler, sums_, counts);
      film_.add(batch_[i].x, batch_[i].y, sums_.color(), hits_[i].has_value(),
                film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
    }
    batch_.clear();
  }

  const Plan& plan_;
  const World& world_;
  const CameraRays& camera_;
  const Nesting& camera_nesting_;
  Film& film_;
  std::unique_ptr<CameraIntegrator> integrator_;
  RadianceSums sums_;
  std::vector<CameraSample> batch_;
  std::array<RayState, kPacketWidth> states_;
  std::array<std::optional<Hit>, kPacketWidth> hits_;
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
  void add(const RayCounts& rays) { rays_ += rays; }
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
  LightPasses light_passes(scene, plan, world, camera, result.film);
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
      if (light_passes.needed())
        meter.add(light_passes.run(pass, samples.last - samples.first, stop, record));
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, plan.tiles.size(), 1),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          const DenormalsOff denormals_off;
                          TileRenderer renderer(scene, plan, world, lamps,
                                                light_passes.needed() ? &light_passes : nullptr,
                                                camera, camera_nesting, result.film);
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
