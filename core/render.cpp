#include "core/render.h"

#include "core/camera.h"
#include "core/cameras/lens_fan.h"
#include "core/integrators/path.h"
#include "core/integrators/whitted.h"
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
#include <optional>
#include <vector>

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
                                                  double pixel_angle) {
  if (plan.settings.integrator == Integrator::path)
    return std::make_unique<Path>(plan, world, lamps, pixel_angle);
  return std::make_unique<Whitted>(scene, plan, world, pixel_angle);
}

/// A scene's camera: the rays of a pinhole or a thin lens, or those of a real lens.
struct PlacedCamera {
  CameraRays rays;
  std::optional<LensCamera> lens;
  Nesting nesting;

  PlacedCamera(const Scene& scene, const RenderSettings& settings, const World& world)
      : rays(scene.camera, settings.width, settings.height),
        nesting(world.nesting_at(scene.camera.eye)) {
    if (scene.camera.lens)
      lens.emplace(scene.camera, scene.mm_per_unit, settings.width, settings.height);
  }
  [[nodiscard]] double pixel_angle() const {
    return lens ? lens->pixel_angle() : rays.pixel_angle();
  }
};

/// Which samples of each pixel are to be rendered: [first, last).
struct SampleRange {
  int first, last;
};

/// Renders tiles on one thread.
class TileRenderer {
public:
  TileRenderer(const Scene& scene, const Plan& plan, const World& world, const Lamps& lamps,
               const PlacedCamera& camera, Film& film)
      : plan_(plan), world_(world), camera_(camera), film_(film),
        integrator_(make_integrator(scene, plan, world, lamps, camera.pixel_angle())),
        sums_(plan), undivided_{plan.first_band, plan.last_band} {
    if (camera.lens) lens_fan_.emplace(plan, *camera.lens);
  }

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

  [[nodiscard]] dvec2 film_position(const CameraSample& sample) const {
    return dvec2(sample.x + 0.5, sample.y + 0.5) +
           filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
  }

  /// One ray for all bands of each sample.
  void start_undivided() {
    states_.resize(batch_.size());
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const CameraSample& sample = batch_[i];
      const dvec2 position = film_position(sample);
      states_[i].ray = camera_.rays.has_aperture()
                           ? camera_.rays.ray(position, sample.sampler.pair(kLens))
                           : camera_.rays.ray(position);
      states_[i].nesting = camera_.nesting;
    }
  }

  /// As many rays for each sample as the lens parts its bands into, or none.
  void start_through_lens() {
    bundles_.clear();
    states_.clear();
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const Sampler& sampler = batch_[i].sampler;
      const dvec2 u = sampler.pair(kWavelength);
      lens_fan_->sample(film_position(batch_[i]), sampler.pair(kLens),
                        {plan_.settings.jitter ? u.x : 0.5, u.y}, bundles_, states_);
      ends_[i] = bundles_.size();
    }
    for (RayState& state : states_)
      state.nesting = camera_.nesting;
  }

  void finish_batch(bool empty, RayCounts& counts) {
    if (lens_fan_)
      start_through_lens();
    else
      start_undivided();
    if (hits_.size() < states_.size()) hits_.resize(states_.size());
    const std::span<const RayState> states(states_);
    const std::span<std::optional<Hit>> hits(hits_.data(), states.size());
    if (empty) {
      std::fill(hits.begin(), hits.end(), std::nullopt);
    } else {
      world_.closest(states, hits, plan_.settings.tracing);
      counts.add(RayKind::camera, states);
    }
    std::size_t first = 0;
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      const std::size_t own = lens_fan_ ? ends_[i] - first : 1;
      trace_sample(batch_[i],
                   {lens_fan_ ? &bundles_[first] : &undivided_, &states[first], &hits[first], own},
                   counts);
      first += own;
    }
    batch_.clear();
  }

  void trace_sample(const CameraSample& sample, const CameraPaths& start, RayCounts& counts) {
    sums_.clear();
    integrator_->trace(start, sample.sampler, sums_, counts);
    bool covered = false;
    for (std::size_t i = 0; i < start.count; ++i)
      covered |= start.hits[i].has_value();
    film_.add(sample.x, sample.y, sums_.color(), covered,
              film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
  }

  const Plan& plan_;
  const World& world_;
  const PlacedCamera& camera_;
  Film& film_;
  std::unique_ptr<CameraIntegrator> integrator_;
  RadianceSums sums_;
  std::vector<CameraSample> batch_;
  std::optional<LensFan> lens_fan_;
  std::array<std::size_t, kPacketWidth> ends_{}; ///< of each sample's bundles in the lists below
  const CameraBundle undivided_; ///< what a sample starts with where no lens parts its bands
  std::vector<CameraBundle> bundles_;
  std::vector<RayState> states_;
  std::vector<std::optional<Hit>> hits_;
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
  const PlacedCamera camera(scene, settings, world);
  const Lamps lamps(scene, plan);
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
                          TileRenderer renderer(scene, plan, world, lamps, camera, result.film);
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
