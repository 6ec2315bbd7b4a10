#include "core/render/tile_renderer.h"

#include "core/integrators/path.h"
#include "core/integrators/whitted.h"

#include <algorithm>
#include <span>

namespace abbe {
namespace {

std::unique_ptr<CameraIntegrator> make_integrator(const RenderContext& context) {
  const auto& [scene, plan, world, camera, lights, light_passes] = context;
  const double pixel_angle = camera.pixel_angle();
  if (plan.settings.integrator == Integrator::path)
    return std::make_unique<Path>(plan, world, lights,
                                  light_passes.needed() ? &light_passes : nullptr, pixel_angle);
  return std::make_unique<Whitted>(scene, plan, world, lights, pixel_angle);
}

} // namespace

RenderContext::RenderContext(const Scene& the_scene, const Plan& the_plan, const World& the_world)
    : scene(the_scene), plan(the_plan), world(the_world), camera(scene, plan.settings, world),
      lights(scene, plan), light_passes(scene, plan, world, camera.connects() ? &camera : nullptr) {
  lights.place(world);
}

TileRenderer::TileRenderer(const RenderContext& context, Film& film,
                           std::span<std::uint32_t> pixel_rays)
    : plan_(context.plan), world_(context.world), film_(film),
      transparency_(film.find(kTransparency)), transmittance_(film.find(kTransmittance)),
      pixel_rays_(pixel_rays), integrator_(make_integrator(context)),
      sums_(plan_, film.find(kEvidence).has_value()), evidence_(film.find(kEvidence)),
      start_(plan_, context.camera) {}

SampleRange PassSamples::of(const Film& film, int x, int y) const {
  if (allocation_.empty()) return all_;
  const auto wanted = static_cast<int>(allocation_[film.window().index(x, y)]);
  const auto has = static_cast<int>(film.samples(x, y));
  return {has, has + (std::max(wanted - has, 0) + passes_left_ - 1) / passes_left_};
}

RayCounts TileRenderer::render(const Tile& tile, const PassSamples& samples, RayRecord* record,
                               std::uint64_t& rendered) {
  RayCounts counts;
  counts.record = record;
  for_each_pixel(tile.window, [&](int x, int y) {
    const SampleRange range = samples.of(film_, x, y);
    rendered += static_cast<std::uint64_t>(range.last - range.first);
    for (int s = range.first; s < range.last; ++s) {
      const auto index = static_cast<std::uint32_t>(s);
      batch_.push_back({x, y, index, Sampler(x, y, index, plan_.settings.seed)});
      if (batch_.size() == kPacketWidth) finish_batch(tile.empty, counts);
    }
  });
  finish_batch(tile.empty, counts);
  return counts;
}

dvec2 TileRenderer::film_position(const CameraSample& sample) const {
  return dvec2(sample.x + 0.5, sample.y + 0.5) +
         filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
}

void TileRenderer::finish_batch(bool empty, RayCounts& counts) {
  start_.clear();
  for (const CameraSample& sample : batch_)
    start_.add(film_position(sample), sample.sampler);
  const std::span<const RayState> states = start_.states();
  if (hits_.size() < states.size()) hits_.resize(states.size());
  const std::span<Hit> hits(hits_.data(), states.size());
  if (empty) {
    for (Hit& hit : hits)
      hit.shape = {};
  } else {
    world_.find_closest(states, hits, plan_.settings.tracing);
    counts.add(RayKind::camera, states);
  }
  for (std::size_t i = 0; i < batch_.size(); ++i)
    trace_sample(batch_[i], start_.paths(i, hits.data()), counts);
  batch_.clear();
}

void TileRenderer::trace_sample(const CameraSample& sample, const CameraPaths& start,
                                RayCounts& counts) {
  sums_.clear();
  const std::uint64_t before = counts.total();
  integrator_->trace(start, sample.sampler, sums_, counts);
  if (!pixel_rays_.empty())
    pixel_rays_[film_.window().index(sample.x, sample.y)] +=
        static_cast<std::uint32_t>(start.count + counts.total() - before);
  bool covered = false;
  for (std::size_t i = 0; i < start.count; ++i)
    covered |= start.hits[i].met();
  const Film::Place place =
      film_.add({sample.x, sample.y, sample.index, covered}, sums_.color(),
                film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
  if (evidence_) film_.add(*evidence_, place, sums_.own_color());
  if (transparency_ && sums_.transparency() != 0.0)
    film_.add(*transparency_, place, sums_.transparency());
  if (transmittance_) film_.add(*transmittance_, place, sums_.transmittance());
}

} // namespace abbe
