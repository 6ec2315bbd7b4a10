#include "core/tile_renderer.h"

#include "core/integrators/path.h"
#include "core/integrators/whitted.h"

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

} // namespace

TileRenderer::TileRenderer(const Scene& scene, const Plan& plan, const World& world,
                           const Lamps& lamps, const LightPasses* light_passes,
                           const CameraRays& camera, const Nesting& camera_nesting, Film& film)
    : plan_(plan), world_(world), camera_(camera), camera_nesting_(camera_nesting), film_(film),
      integrator_(make_integrator(scene, plan, world, lamps, light_passes, camera.pixel_angle())),
      sums_(plan) {}

RayCounts TileRenderer::render(const Tile& tile, SampleRange samples, RayRecord* record) {
  RayCounts counts;
  counts.record = record;
  const PixelWindow& w = tile.window;
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x)
      for (int s = samples.first; s < samples.last; ++s) {
        batch_.push_back({x, y, Sampler(x, y, static_cast<std::uint32_t>(s), plan_.settings.seed)});
        if (batch_.size() == kPacketWidth) finish_batch(tile.empty, counts);
      }
  finish_batch(tile.empty, counts);
  return counts;
}

void TileRenderer::finish_batch(bool empty, RayCounts& counts) {
  const std::size_t count = batch_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const CameraSample& sample = batch_[i];
    const dvec2 offset = filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
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

} // namespace abbe
