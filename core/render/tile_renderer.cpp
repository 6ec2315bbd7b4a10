#include "core/render/tile_renderer.h"

#include "core/integrators/path.h"
#include "core/integrators/whitted.h"

#include <algorithm>
#include <span>

namespace abbe {
namespace {

std::unique_ptr<CameraIntegrator> make_integrator(const Scene& scene, const Plan& plan,
                                                  const World& world, const Lamps& lamps,
                                                  const LightPasses* light_passes,
                                                  double pixel_angle) {
  if (plan.settings.integrator == Integrator::path)
    return std::make_unique<Path>(plan, world, lamps, light_passes, pixel_angle);
  return std::make_unique<Whitted>(scene, plan, world, lamps, pixel_angle);
}

/// Row by row.
std::size_t pixel_index(const PixelWindow& window, int x, int y) {
  return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
         static_cast<std::size_t>(x - window.x0);
}

} // namespace

TileRenderer::TileRenderer(const Scene& scene, const Plan& plan, const World& world,
                           const Lamps& lamps, const LightPasses* light_passes,
                           const PlacedCamera& camera, Film& film,
                           std::span<std::uint32_t> pixel_rays)
    : plan_(plan), world_(world), camera_(camera), film_(film), pixel_rays_(pixel_rays),
      integrator_(make_integrator(scene, plan, world, lamps, light_passes, camera.pixel_angle())),
      sums_(plan), undivided_{.bands = {plan.first_band, plan.last_band}} {
  if (camera.lens) lens_fan_.emplace(plan, *camera.lens);
}

SampleRange PassSamples::of(const Film& film, int x, int y) const {
  if (allocation_.empty()) return all_;
  const auto wanted = static_cast<int>(allocation_[pixel_index(film.window(), x, y)]);
  const auto has = static_cast<int>(film.samples(x, y));
  return {has, has + (std::max(wanted - has, 0) + passes_left_ - 1) / passes_left_};
}

RayCounts TileRenderer::render(const Tile& tile, const PassSamples& samples, RayRecord* record,
                               std::uint64_t& rendered) {
  RayCounts counts;
  counts.record = record;
  const PixelWindow& w = tile.window;
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x) {
      const SampleRange range = samples.of(film_, x, y);
      rendered += static_cast<std::uint64_t>(range.last - range.first);
      for (int s = range.first; s < range.last; ++s) {
        batch_.push_back({x, y, Sampler(x, y, static_cast<std::uint32_t>(s), plan_.settings.seed)});
        if (batch_.size() == kPacketWidth) finish_batch(tile.empty, counts);
      }
    }
  finish_batch(tile.empty, counts);
  return counts;
}

dvec2 TileRenderer::film_position(const CameraSample& sample) const {
  return dvec2(sample.x + 0.5, sample.y + 0.5) +
         filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
}

void TileRenderer::start_undivided() {
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

void TileRenderer::start_through_lens() {
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

void TileRenderer::finish_batch(bool empty, RayCounts& counts) {
  if (lens_fan_)
    start_through_lens();
  else
    start_undivided();
  if (hits_.size() < states_.size()) hits_.resize(states_.size());
  const std::span<const RayState> states(states_);
  const std::span<Hit> hits(hits_.data(), states.size());
  if (empty) {
    for (Hit& hit : hits)
      hit.shape = {};
  } else {
    world_.find_closest(states, hits, plan_.settings.tracing);
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

void TileRenderer::trace_sample(const CameraSample& sample, const CameraPaths& start,
                                RayCounts& counts) {
  sums_.clear();
  const std::uint64_t before = counts.total();
  integrator_->trace(start, sample.sampler, sums_, counts);
  if (!pixel_rays_.empty())
    pixel_rays_[pixel_index(film_.window(), sample.x, sample.y)] +=
        static_cast<std::uint32_t>(start.count + counts.total() - before);
  bool covered = false;
  for (std::size_t i = 0; i < start.count; ++i)
    covered |= start.hits[i].met();
  film_.add(sample.x, sample.y, sums_.color(), covered,
            film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
}

} // namespace abbe
