#include "core/integrators/path.h"

#include "core/integrators/tree_growth.h"

#include <algorithm>
#include <utility>

namespace abbe {
namespace {

/// A branch is followed for sure when it brings this part of what the image's bands could.
constexpr double kBranchShare = 1.0 / 32.0;

} // namespace

Path::Path(const Plan& plan, const World& world, const Lights& lights,
           const LightPasses* light_passes, double pixel_angle)
    : CameraIntegrator(plan), RandomWalk(plan, world, pixel_angle, Transport::radiance),
      lights_(lights), photons_(light_passes ? &light_passes->map() : nullptr),
      emission_(light_passes ? &light_passes->emission() : nullptr),
      found_otherwise_(light_passes || plan.settings.shadows == ShadowRule::attenuated),
      shadow_rays_(plan, world), single_scatter_(lights, plan, world), sky_(plan, lights),
      light_(plan.stride), kept_(plan.stride) {}

/// Does a step of a path beyond the depth limit: with its own counts and sums.
template <class Step>
void Path::aside(Step&& step) {
  RayCounts* const counts = std::exchange(counts_, &beyond_.rays);
  RadianceSums* const sums = std::exchange(sums_, &beyond_.sums);
  single_scatter_.send_to(*sums_, *counts_);
  step();
  sums_ = sums;
  counts_ = counts;
  single_scatter_.send_to(*sums_, *counts_);
}

bool Path::trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
                 RayCounts& counts) {
  begin(sampler, counts);
  beyond_.begin_path(sampler);
  single_scatter_.begin_path(sampler, wavelengths_, sums, counts);
  sums_ = &sums;
  for (std::size_t i = 0; i < start.count; ++i) {
    start.begin(i, bundle());
    sky_.begin_path(bundle().state.ray.direction);
    const BandSpan<float> row = throughput();
    for (int b = row.bands.first; b < row.bands.last; ++b)
      row[b] = plan_.live[static_cast<std::size_t>(b)] * start.bundles[i].weight;
    wait();
    while (take()) {
      if (end_check_.gives_up()) {
        give_up();
        return false;
      }
      if (bundle().depth > beyond_.limit) [[unlikely]] {
        aside([&] {
          extend();
          shade();
        });
        continue;
      }
      extend();
      shade();
    }
  }
  return true;
}

void Path::shade() {
  if (!single_scatter_.arrive(bundle(), throughput())) return wait();
  if (sums_->divided()) [[unlikely]]
    sums_->classify(bundle().view, arrival_of_seen());
  gather();
  if (!bundle().hit.met()) return;
  if (bundle().depth != beyond_.limit) return go_on();
  if (beyond_.chosen()) go_on_beyond();
  look_through();
}

/// The path goes on beyond the limit, and stays as it is.
void Path::go_on_beyond() {
  const Bundle here = bundle();
  const BandRange bands = here.bands;
  const float* row = throughput().data;
  std::copy(row + bands.first, row + bands.last, kept_.begin() + bands.first);
  aside([&] { go_on(); });
  bundle() = here;
  std::copy(kept_.begin() + bands.first, kept_.begin() + bands.last,
            throughput().data + bands.first);
}

/// A pane does not end the path, however many surfaces it has met: only what it reflects is lost.
void Path::look_through() {
  if (!find_material().facts().passes) return;
  prepare_scattering();
  pass(1.0);
}

/// How light has come that the bundle sees by itself.
Arrival Path::arrival_of_seen() const {
  const bool by_specular = bundle().pdf == 0.0;
  switch (bundle().nonspecular_bounces) {
  case 0:
    return Arrival::direct;
  case 1:
    return by_specular ? Arrival::caustic : Arrival::direct;
  default:
    return Arrival::indirect;
  }
}

/// The same of a light that is sampled at the bundle's hit (`straight`), or of photons there.
Arrival Path::arrival_here(bool straight) const {
  if (bundle().nonspecular_bounces > 0) return Arrival::indirect;
  return straight ? Arrival::direct : Arrival::caustic;
}

void Path::gather() {
  if (!bundle().hit.met()) {
    const bool by_chance = comes_by_mirrors_and_glass();
    sky_.add(bundle(),
             {.suns = by_chance && found_otherwise_,
              .bright = by_chance && emission_ && emission_->sky_emits()},
             throughput(), *sums_);
    return;
  }
  const Hit& hit = bundle().hit;
  const MaterialPlan& material = find_material();
  if (!material.emits(hit) || found_otherwise(hit)) return;
  double weight = 1.0;
  if (bundle().pdf > 0.0) {
    const dvec3 scattered_at = bundle().state.ray.at(-bundle().unseen_length);
    weight = bundle().pdf / (bundle().pdf + lights_.pdf(scattered_at, hit));
  }
  sums_->add(material.emission_source, throughput(), ones_, static_cast<float>(weight));
}

/// True for light that goes from a light by mirrors and glass to a surface that scatters it, where
/// light paths find it, or shadow rays that pass through glass count it.
bool Path::found_otherwise(const Hit& emitting) const {
  if (!comes_by_mirrors_and_glass() || !found_otherwise_) return false;
  return !emission_ || emission_->emits(emitting.shape);
}

/// True where light paths bring caustics to the film: on what the camera sees directly, and on what
/// lights that by way of mirrors and glass.
bool Path::splatted() const {
  if (!photons_->splatted()) return false;
  return bundle().depth == 0 ||
         (comes_by_mirrors_and_glass() && bundle().nonspecular_bounces == 1 &&
          bundle().first_nonspecular_depth == 0);
}

bool Path::comes_by_mirrors_and_glass() const {
  return bundle().nonspecular_bounces > 0 && bundle().pdf == 0.0;
}

void Path::go_on() {
  const Hit& hit = bundle().hit;
  prepare_scattering();
  if (scattering_.has_nonspecular()) {
    if (!lights_.empty()) sample_light(hit);
    if (photons_ && !splatted()) look_up_photons(hit);
  }
  const Scattering::Choice on = branch();
  switch (on.kind) {
  case ScatterKind::none:
    return;
  case ScatterKind::reflect:
    return reflect(on.chance);
  case ScatterKind::refract:
    return refract(on.chance);
  case ScatterKind::pass:
    if (bundle().depth == beyond_.limit) return; // the limit does not end it
    return pass(on.chance);
  case ScatterKind::nonspecular:
    break;
  }
  const auto next = scattering_.sample(
      numbers(kDirection), scattering_.has_lobes() ? numbers(kLobe) : dvec2(0.0), light_.data());
  if (!next) return;
  scatter(next->direction, light_.data(), next->pdf, scattering_.nonspecular_chance() / on.chance);
}

/// How the path goes on. Where the camera sees a surface itself, or by way of mirrors and glass,
/// what is reflected may branch off: one of the parts at random would leave grain. Behind many
/// surfaces all branches together would: their number would vary ever more.
Scattering::Choice Path::branch() {
  if (scattering_.certain()) return scattering_.choose(0.0);
  const double u = numbers(kScatter).x;
  const double eagerness =
      bundle().has_pixel_footprint && bundle().surfaces() < kSurfacesOfTree
          ? share(importance(bundle().hit.medium_before), bundle().bands) / kBranchShare
          : 0.0;
  const auto [reflect_chance, on] = scattering_.branch(u, eagerness);
  if (reflect_chance == 0.0) return on;
  if (on.kind == ScatterKind::none) return {ScatterKind::reflect, reflect_chance};
  branch_off_reflection(scattering_.reflected(), 1.0 / reflect_chance).route = route_on(false);
  return on;
}

void Path::sample_light(const Hit& hit) {
  const double choice = lights_.single() ? 0.0 : numbers(kLightChoice).x;
  const auto sample = lights_.sample(hit.point, choice, numbers(kLightPoint));
  if (!sample) return;
  const BandSpan<float> light{light_.data(), bundle().bands};
  const double pdf = scattering_.evaluate(sample->direction, light.data);
  if (!(pdf > 0.0)) return;
  const bool outwards = glm::dot(sample->direction, hit.normal) > 0.0;
  const bool through = outwards != hit.entering;
  if (sky_.leaves_out(route_on(through), *sample)) return;
  const RayState towards_light = hit.going_on(sample->direction, through);
  const float* arriving =
      shadow_rays_.transmittance(towards_light, *sample, light.bands, wavelengths_, *counts_);
  if (!arriving) return;
  double weight = sample->weight;
  if (shadow_rays_.through_glass()) {
    // Paths that meet the light behind glass leave it to this ray, but not the environment.
    if (sample->environment) return;
  } else if (sample->pdf > 0.0) {
    weight *= sample->pdf / (sample->pdf + pdf);
  }
  const BandSpan<const float> carried = throughput();
  for (int b = light.bands.first; b < light.bands.last; ++b)
    light[b] *= carried[b] * arriving[b];
  lights_.tint(*sample, light);
  if (sums_->divided()) [[unlikely]]
    sums_->classify(bundle().view, arrival_here(true));
  sums_->add(sample->source, light, ones_, static_cast<float>(weight));
}

void Path::look_up_photons(const Hit& hit) {
  if (sums_->divided()) [[unlikely]]
    sums_->classify(bundle().view, arrival_here(false));
  photons_->for_each_near(
      hit, scattering_.transmits_nonspecular(), [&](const Photon& photon, const float* flux) {
        const BandSpan<const float> carried = throughput();
        const BandSpan<float> light{light_.data(),
                                    {std::max(carried.bands.first, photon.bands.first),
                                     std::min(carried.bands.last, photon.bands.last)}};
        if (light.bands.size() <= 0) return;
        const double cosine = std::abs(glm::dot(photon.direction, hit.normal));
        if (!(scattering_.evaluate(-photon.direction, light.data) > 0.0)) return;
        for (int b = light.bands.first; b < light.bands.last; ++b)
          light[b] *= carried[b] * flux[b - photon.bands.first];
        // The surfaces that the photon has met count as well.
        const bool ends =
            bundle().depth + 1 + photon.depth > beyond_.limit && sums_ != &beyond_.sums;
        RadianceSums& sums = ends ? beyond_.sums : *sums_;
        const double share = ends ? 1.0 / BeyondLimit::kOneIn : 1.0;
        sums.add_mapped(photon.source, light, ones_,
                        static_cast<float>(share * photons_->density_factor() / cosine));
      });
}

} // namespace abbe
