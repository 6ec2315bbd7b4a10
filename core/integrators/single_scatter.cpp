#include "core/integrators/single_scatter.h"

#include "core/integrators/absorption.h"
#include "core/integrators/straight_on.h"
#include "core/lights/light_kinds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {

SingleScatter::SingleScatter(const Scene& scene, const Plan& plan, const World& world)
    : scene_(&scene), plan_(plan), world_(world), shadow_rays_(plan, world),
      ones_(1.0f, plan.grid.count()), seen_(plan.stride), lit_(plan.stride) {}

SingleScatter::SingleScatter(const Lights& lights, const Plan& plan, const World& world)
    : lights_(&lights), plan_(plan), world_(world), shadow_rays_(plan, world),
      ones_(1.0f, plan.grid.count()), seen_(plan.stride), lit_(plan.stride) {}

void SingleScatter::begin_path(const Sampler& sampler, PathWavelengths& wavelengths,
                               RadianceSums& sums, RayCounts& counts) {
  wavelengths_ = &wavelengths;
  sums_ = &sums;
  counts_ = &counts;
  if (!plan_.has_drops) return;
  place_ = sampler.pair(kDropPlace);
  light_point_ = sampler.pair(kDropLight);
}

bool SingleScatter::arrive(Bundle& bundle, BandSpan<float> throughput) {
  const Hit& hit = bundle.hit;
  const double length = hit.met() ? hit.t : kInfinity;
  const MediumPlan& medium =
      plan_.medium(hit.met() ? hit.medium_before : world_.medium_of(bundle.state.nesting));
  if (medium.drops) add(bundle, length, medium, throughput);
  absorb(medium, length, throughput);
  if (!hit.met() || !plan_.unseen(hit)) return true;
  go_straight_on(bundle);
  return false;
}

void SingleScatter::find_lights(const dvec3& place) {
  incoming_.clear();
  if (lights_) {
    if (const auto light = lights_->sample(place, place_.y, light_point_))
      incoming_.push_back({light->direction, light->distance, light->weight, light->source,
                           std::isinf(light->distance) && light->pdf == 0.0, light});
    return;
  }
  for (std::size_t i = 0; i < scene_->lights.size(); ++i) {
    const Illumination light = illumination(scene_->lights[i], place);
    if (light.strength > 0.0)
      incoming_.push_back({light.direction, light.distance, std::numbers::pi * light.strength,
                           plan_.light_source(i), std::isinf(light.distance), std::nullopt});
  }
}

void SingleScatter::add(const Bundle& bundle, double length, const MediumPlan& medium,
                        BandSpan<const float> throughput) {
  const DropsPlan& drops = *medium.drops;
  const double extinction = drops.extinction_per_unit;
  const double scattered = -std::expm1(-extinction * length); // of what comes the whole length
  const double distance = -std::log1p(-place_.x * scattered) / extinction;
  const dvec3 point = bundle.state.ray.at(distance);
  find_lights(point);
  if (incoming_.empty()) return;
  // The ray may have passed boundaries between equal media, so its own nesting need not hold here.
  const Nesting nesting = world_.nesting_at(point);
  const BandRange bands = throughput.bands;
  const BandSpan<float> seen{seen_.data(), bands}, lit{lit_.data(), bands};
  std::copy(throughput.data + bands.first, throughput.data + bands.last, seen.data + bands.first);
  absorb(medium, distance, seen);
  // s exp(-s t) over the pdf of the place; `absorb` has applied exp(-s t) already.
  const double weight = scattered * std::exp(extinction * distance);

  if (sums_->divided()) [[unlikely]]
    sums_->classify(bundle.view,
                    bundle.nonspecular_bounces == 0 ? Arrival::direct : Arrival::indirect);
  for (const IncomingLight& light : incoming_) {
    const RayState towards_light{{point, light.direction}, {}, nesting};
    const float* arriving = light.sample
                                ? shadow_rays_.transmittance(towards_light, *light.sample, bands,
                                                             *wavelengths_, *counts_)
                                : shadow_rays_.transmittance(towards_light, light.distance, bands,
                                                             *wavelengths_, *counts_);
    if (!arriving) continue;
    const auto& phase = light.disc ? drops.under_sun : drops.near_light;
    const auto part = phase->at(glm::dot(light.direction, bundle.state.ray.direction));
    for (int b = bands.first; b < bands.last; ++b)
      lit[b] = seen[b] * arriving[b] * part[b];
    if (light.sample) lights_->tint(*light.sample, lit);
    sums_->add(light.source, lit, ones_, static_cast<float>(weight * light.weight));
  }
}

} // namespace abbe
