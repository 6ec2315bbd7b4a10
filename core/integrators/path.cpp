#include "core/integrators/path.h"

#include "core/materials/fresnel.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Paths are ended at random from this many surfaces on; before, nearly all carry much.
constexpr int kSureSurfaces = 3;

} // namespace

Path::Path(const Plan& plan, const World& world, const Lamps& lamps, double pixel_angle)
    : plan_(plan), world_(world), lamps_(lamps), wavelengths_(plan), fan_(plan, world, pixel_angle),
      shadow_rays_(plan, world), single_scatter_(lamps, plan, world), scattering_(plan),
      ones_(1.0f, plan.grid.count()), throughput_(plan.stride), light_(plan.stride) {}

dvec2 Path::numbers(SamplePurpose purpose) const {
  return sampler_->pair(purpose + kPerSurface * static_cast<std::uint32_t>(bundle_.depth));
}

void Path::push(const Bundle& bundle, float weight) {
  waiting_.push_back(bundle);
  if (throughputs_.size() < waiting_.size() * plan_.stride)
    throughputs_.resize(waiting_.size() * plan_.stride);
  float* target = row(waiting_.size() - 1);
  for (int b = bundle.first; b < bundle.last; ++b)
    target[b] = throughput_[static_cast<std::size_t>(b)] * weight;
}

void Path::trace(const RayState& camera_ray, const std::optional<Hit>& hit, const Sampler& sampler,
                 RadianceSums& sums, RayCounts& counts) {
  sampler_ = &sampler;
  sums_ = &sums;
  counts_ = &counts;
  single_scatter_.begin_path(sampler);
  const dvec2 u = sampler.pair(kWavelength);
  wavelengths_.begin_path(plan_.settings.jitter ? u.x : 0.5);
  band_choice_ = u.y;
  bundle_ = Bundle{};
  bundle_.first = plan_.first_band;
  bundle_.last = plan_.last_band;
  bundle_.state = camera_ray;
  bundle_.hit = hit;
  std::copy(plan_.live.begin(), plan_.live.end(), throughput_.begin());
  follow();
  while (!waiting_.empty()) {
    resume();
    follow();
  }
}

void Path::follow() {
  do
    gather();
  while (bundle_.hit && bundle_.depth < plan_.settings.max_depth && go_on());
}

void Path::gather() {
  const int first = bundle_.first, last = bundle_.last;
  single_scatter_.arrive(bundle_, throughput_.data(), wavelengths_, *sums_, *counts_);
  if (!bundle_.hit) {
    sums_->add(Plan::kBackground, throughput_.data(), ones_, 1.0f, first, last);
    return;
  }
  const Hit& hit = *bundle_.hit;
  const MaterialPlan& material = plan_.materials[hit.material.index()];
  if (!material.emits(hit)) return;
  double weight = 1.0;
  if (bundle_.density > 0.0) {
    const dvec3 spread_at = bundle_.state.ray.at(-bundle_.passed);
    weight = bundle_.density / (bundle_.density + lamps_.density(spread_at, hit));
  }
  sums_->add(material.emission_source, throughput_.data(), ones_, static_cast<float>(weight), first,
             last);
}

bool Path::go_on() {
  const MaterialPlan& material = plan_.materials[bundle_.hit->material.index()];
  scattering_.prepare(material, *bundle_.hit, bundle_.state.ray.direction, bundle_.first,
                      bundle_.last, throughput_.data(), wavelengths_);
  if (scattering_.spreads() && !lamps_.empty()) aim_at_a_lamp(*bundle_.hit);
  const Scattering::Choice choice =
      scattering_.choose(scattering_.certain() ? 0.0 : numbers(kScatter).x);
  switch (choice.kind) {
  case ScatterKind::none:
    return false;
  case ScatterKind::reflect:
    return reflect(choice.chance);
  case ScatterKind::refract:
    return refract(choice.chance);
  case ScatterKind::spread:
    return spread();
  }
  return false;
}

void Path::aim_at_a_lamp(const Hit& hit) {
  const double choice = lamps_.single() ? 0.0 : numbers(kLamp).x;
  const auto lamp = lamps_.sample(hit.point, choice, numbers(kLampPoint));
  if (!lamp) return;
  const int first = bundle_.first, last = bundle_.last;
  const double density = scattering_.evaluate(lamp->direction, light_.data());
  if (!(density > 0.0)) return;
  const RayState towards_lamp{{hit.point, lamp->direction}, hit.same_side, hit.nesting_before};
  const float* arriving =
      shadow_rays_.transmittance(towards_lamp, lamp->distance, first, last, wavelengths_, *counts_);
  if (!arriving) return;
  double weight = lamp->weight;
  if (lamp->density > 0.0) weight *= lamp->density / (lamp->density + density);
  for (int b = first; b < last; ++b)
    light_[static_cast<std::size_t>(b)] *= throughput_[static_cast<std::size_t>(b)] * arriving[b];
  sums_->add(lamp->source, light_.data(), ones_, static_cast<float>(weight), first, last);
}

/// Multiplies the throughput by factors and a weight.
void Path::scale(const float* factors, double weight) {
  const auto w = static_cast<float>(weight);
  for (int b = bundle_.first; b < bundle_.last; ++b)
    throughput_[static_cast<std::size_t>(b)] *= factors[b] * w;
}

/// Russian roulette on what the bundle would bring behind its hit: the largest throughput of its
/// bands, times n^2 of the medium there, since radiance is n^2 times that outside.
bool Path::survives(MediumId medium) {
  const int first = bundle_.first, last = bundle_.last;
  float most = 0.0f;
  for (int b = first; b < last; ++b)
    most = std::max(most, throughput_[static_cast<std::size_t>(b)]);
  if (!(most > 0.0f)) return false;
  const double n = wavelengths_.indices(medium)[first];
  importance_ = static_cast<double>(most) * n * n;
  if (bundle_.depth < kSureSurfaces || importance_ >= 1.0) return true;
  if (numbers(kScatter).y >= importance_) return false;
  scale(ones_.data(), 1.0 / importance_);
  importance_ = 1.0;
  return true;
}

/// Sets off along a direction on the side that the ray came from, and traces.
bool Path::leave(const dvec3& direction, RayKind kind) {
  Hit& hit = *bundle_.hit;
  if (!survives(hit.medium_before)) return false;
  bundle_.state.ray = {hit.point, direction};
  bundle_.state.contacts = hit.same_side;
  bundle_.state.nesting = hit.nesting_before;
  bundle_.position_spread += bundle_.direction_spread * hit.t;
  bundle_.path_length += hit.t;
  bundle_.passed = 0.0;
  ++bundle_.depth;
  bundle_.hit = world_.closest(bundle_.state);
  counts_->add(kind, bundle_.state);
  return true;
}

bool Path::reflect(double chance) {
  const Hit& hit = *bundle_.hit;
  scale(scattering_.reflected(), 1.0 / chance);
  bundle_.density = 0.0;
  return leave(reflected(bundle_.state.ray.direction, hit.entering ? hit.normal : -hit.normal),
               RayKind::reflected);
}

bool Path::spread() {
  const auto direction = scattering_.sample(numbers(kDirection));
  if (!direction) return false;
  const double density = scattering_.evaluate(*direction, light_.data());
  if (!(density > 0.0)) return false;
  scale(light_.data(), 1.0 / density);
  bundle_.density = density;
  bundle_.spread = true;
  bundle_.position_spread = bundle_.direction_spread = 0.0;
  return leave(*direction, RayKind::spread);
}

/// The fan's sub-bundles wait for their turns; the last goes on at once.
bool Path::refract(double chance) {
  scale(scattering_.transmitted(), 1.0 / chance);
  bundle_.density = 0.0;
  if (!survives(bundle_.hit->medium_after)) return false;
  // Bands under total reflection, and those without power, have no refracted ray. What remains is
  // one run of bands as a rule, and more where n(lambda) turns.
  const auto passes = [&](int b) { return throughput_[static_cast<std::size_t>(b)] > 0.0f; };
  const std::size_t before = waiting_.size();
  const Bundle incoming = bundle_;
  for (int first = incoming.first; first < incoming.last;) {
    if (!passes(first)) {
      ++first;
      continue;
    }
    int last = first + 1;
    while (last < incoming.last && passes(last))
      ++last;
    const auto& cells =
        fan_.refract(incoming, first, last, importance_, wavelengths_, band_choice_, *counts_);
    for (const FanCell& cell : cells)
      push(cell.bundle, cell.weight);
    first = last;
  }
  return waiting_.size() > before && resume();
}

/// Takes up the bundle that was pushed last.
bool Path::resume() {
  bundle_ = waiting_.back();
  const float* stored = row(waiting_.size() - 1);
  std::copy(stored + bundle_.first, stored + bundle_.last, throughput_.begin() + bundle_.first);
  waiting_.pop_back();
  return true;
}

} // namespace abbe
