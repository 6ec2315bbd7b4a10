#include "core/render/tile_renderer.h"

#include "core/film/lost_light.h"
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
                           std::span<std::uint32_t> pixel_rays, const IsOver& is_over)
    : plan_(context.plan), world_(context.world), film_(film),
      transparency_(film.find(kTransparency)), transmittance_(film.find(kTransmittance)),
      pixel_rays_(pixel_rays), integrator_(make_integrator(context)), is_over_(is_over),
      sums_(plan_, film.find(kEvidence).has_value()), evidence_(film.find(kEvidence)),
      lost_(film.find(kLost)), start_(plan_, context.camera) {
  integrator_->end_with(is_over);
  FirstHit first_hit(context.scene, plan_, world_, film);
  if (!first_hit.empty()) first_hit_.emplace(std::move(first_hit));
  PartLayers part_layers(plan_, film);
  if (part_layers.empty()) return;
  const bool divides = part_layers.divides();
  part_layers_.emplace(std::move(part_layers));
  if (!divides) return;
  parts_.emplace(plan_);
  sums_.divide(&*parts_);
}

SampleRange PassSamples::of(const Film& film, int x, int y, int already) const {
  if (allocation_.empty()) return all_;
  const auto wanted = static_cast<int>(allocation_[film.window().index(x, y)]);
  if (mean_ > 0) {
    const auto border = [&](std::int64_t sample) {
      return static_cast<int>((sample * wanted + mean_ - 1) / mean_);
    };
    return {border(all_.first), border(all_.last)};
  }
  const int has = static_cast<int>(film.samples(x, y)) - already;
  return {has, has + (std::max(wanted - has, 0) + passes_left_ - 1) / passes_left_};
}

PassProgress TileRenderer::render(const Tile& tile, const PassSamples& samples, LeftPass& left,
                                  RayRecord* record) {
  PassProgress progress;
  progress.rays.record = record;
  const LeftPass from = left;
  std::uint32_t pixel = 0;
  for_each_pixel(tile.window, [&](int x, int y) {
    const std::uint32_t p = pixel++;
    if (p < from.pixels || !progress.whole) return;
    const int already = p == from.pixels ? static_cast<int>(from.samples) : 0;
    const SampleRange range = samples.of(film_, x, y, already);
    for (int s = range.first + already; s < range.last && progress.whole; ++s) {
      const auto index = static_cast<std::uint32_t>(s);
      batch_.push_back({x,
                        y,
                        index,
                        {p, static_cast<std::uint32_t>(s - range.first) + 1},
                        Sampler(x, y, index, plan_.settings.seed)});
      if (batch_.size() == kPacketWidth) finish_batch(tile.empty, left, progress);
    }
  });
  if (progress.whole) finish_batch(tile.empty, left, progress);
  return progress;
}

dvec2 TileRenderer::film_position(const CameraSample& sample) const {
  return dvec2(sample.x + 0.5, sample.y + 0.5) +
         filter_offset(plan_.settings.filter, sample.sampler.pair(kPixelPosition));
}

void TileRenderer::finish_batch(bool empty, LeftPass& left, PassProgress& progress) {
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
    progress.rays.add(RayKind::camera, states);
  }
  for (std::size_t i = 0; i < batch_.size() && progress.whole; ++i) {
    progress.whole =
        !is_over_() && trace_sample(batch_[i], start_.paths(i, hits.data()), progress.rays);
    if (!progress.whole) {
      if (!empty) progress.rays.camera -= states.size() - start_.first_state(i);
      break;
    }
    left = batch_[i].behind;
    ++progress.rendered;
  }
  batch_.clear();
}

bool TileRenderer::trace_sample(const CameraSample& sample, const CameraPaths& start,
                                RayCounts& counts) {
  sums_.clear();
  if (parts_) parts_->clear();
  const RayCounts before = counts;
  if (!integrator_->trace(start, sample.sampler, sums_, counts)) {
    counts = before;
    return false;
  }
  if (!pixel_rays_.empty())
    pixel_rays_[film_.window().index(sample.x, sample.y)] +=
        static_cast<std::uint32_t>(start.count + counts.total() - before.total());
  bool covered = false;
  for (std::size_t i = 0; i < start.count; ++i)
    covered |= start.hits[i].met();
  const Xyz color = sums_.color();
  const Film::Place place =
      film_.add({sample.x, sample.y, sample.index, covered}, color,
                film_.bands() > 0 ? sums_.radiance() : std::span<const float>());
  if (evidence_) film_.add(*evidence_, place, sums_.own_color());
  if (transparency_ && sums_.transparency() != 0.0)
    film_.add(*transparency_, place, sums_.transparency());
  if (transmittance_) film_.add(*transmittance_, place, sums_.transmittance());
  if (const double lost = lost_ ? integrator_->beyond().luminance() : 0.0; lost != 0.0)
    film_.add(*lost_, place, lost_light(lost, plan_.quantum));
  if (parts_) part_layers_->add(place, color, *parts_);
  if (plan_.settings.band_images) part_layers_->add_bands(place, color, sums_.band_colors());
  if (first_hit_ && covered) first_hit_->add(place, start);
  return true;
}

} // namespace abbe
