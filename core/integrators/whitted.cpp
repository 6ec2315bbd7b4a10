#include "core/integrators/whitted.h"

#include "core/bands/band_math.h"
#include "core/emitters/illumination.h"
#include "core/optics/fresnel.h"
#include "core/scattering/surface_finish.h"
#include "core/scattering/surface_incidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// A branch is followed for sure when it matters at least as much as this part of one of the
/// `max_fan` sub-bundles. Chosen by time against error on scenes/lens and scenes/prism_view, see
/// docs/decisions/bundles.md.
constexpr double kSurePart = 1.0 / 16.0;

} // namespace

Whitted::Whitted(const Scene& scene, const Plan& plan, const World& world, const Lamps& lamps,
                 double pixel_angle)
    : scene_(scene), plan_(plan), world_(world), lamps_(lamps), wavelengths_(plan),
      fan_(plan, world, pixel_angle), shadow_rays_(plan, world),
      single_scatter_(scene, plan, world), reflected_(plan.stride), transmitted_(plan.stride),
      ones_(1.0f, plan.grid.count()), textured_(0.0f, plan.grid.count()), throughput_(plan.stride),
      lit_(plan.stride), coated_(plan.stride) {}

Bundle& Whitted::push(int first, int last, const float* throughput, float factor) {
  if (waiting_.size() == waiting_count_) {
    waiting_.emplace_back();
    throughputs_.resize(waiting_.size() * plan_.stride);
  }
  float* target = row(waiting_count_);
  for (int b = first; b < last; ++b)
    target[b] = throughput[b] * factor;
  Bundle& next = waiting_[waiting_count_++];
  next.first = first;
  next.last = last;
  return next;
}

void Whitted::trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
                    RayCounts& counts) {
  const dvec2 u = sampler.pair(kWavelength);
  decisions_ = sampler.decisions();
  single_scatter_.begin_path(sampler);
  wavelengths_.begin_path(plan_.settings.jitter ? u.x : 0.5);
  for (std::size_t i = 0; i < start.count; ++i)
    start.begin(i, push(start.bundles[i].first, start.bundles[i].last, plan_.live.data(),
                        start.bundles[i].weight));
  while (waiting_count_ > 0) {
    Bundle& bundle = bundle_;
    bundle = waiting_[--waiting_count_];
    const float* stored = row(waiting_count_);
    std::copy(stored + bundle.first, stored + bundle.last, throughput_.begin() + bundle.first);
    single_scatter_.arrive(bundle, throughput_.data(), wavelengths_, sums, counts);
    if (!bundle.hit.met()) {
      add_background(bundle, sums);
      continue;
    }
    const MaterialPlan* material = &plan_.materials[bundle.hit.material.index()];
    if (material->mixture) material = &part_of(plan_, *material, decisions_.next());
    shade(bundle, *material, sums, counts);
    if (bundle.depth < plan_.settings.max_depth) scatter(bundle, *material, u.y, counts);
  }
}

void Whitted::add_background(const Bundle& bundle, RadianceSums& sums) {
  lamps_.add_sky(bundle.state.ray.direction, 0.0, true, throughput_.data(), bundle.first,
                 bundle.last, sums);
}

void Whitted::shade(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                    RayCounts& counts) {
  const auto add = [&](int source, const BandTable& factor) {
    sums.add(source, throughput_.data(), factor, 1.0f, bundle.first, bundle.last);
  };
  const Hit& hit = bundle.hit;
  if (material.emits(hit)) add(material.emission_source, ones_);
  if (!material.ambient.zero()) add(Plan::kAmbient, material.ambient);
  if (material.lit()) add_lamps(bundle, material, sums, counts);
}

/// What arrives of a lamp's light, `lit_`, sent back by a coated ground, with lambert's cosine. The
/// thesis's lamps give pi times the light that a diffuse surface of theirs would need.
const float* Whitted::diffuse_under_coat(const Bundle& bundle, const MaterialPlan& material,
                                         const BandTable& diffuse, double cos_o, double cos_i) {
  const auto at = [](double mu) { return dvec3{std::sqrt(std::max(0.0, 1.0 - mu * mu)), 0.0, mu}; };
  Incidence in =
      surface_incidence(material.bsdf, bundle.hit, {bundle.first, bundle.last}, wavelengths_);
  in.wo = at(cos_o);
  in.ground = diffuse.data();
  (void)evaluate(material.bsdf, in, at(cos_i), coated_.data());
  for (int b = bundle.first; b < bundle.last; ++b)
    coated_[static_cast<std::size_t>(b)] *= lit_[static_cast<std::size_t>(b)];
  return coated_.data();
}

void Whitted::add_lamps(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                        RayCounts& counts) {
  const Hit& hit = bundle.hit;
  const BandTable& diffuse = diffuse_at(plan_, world_, material, hit, textured_);
  const dvec3 to_eye = -bundle.state.ray.direction;
  const dvec3 normal = hit.entering ? hit.normal : -hit.normal;
  const bool coated = facts_of(material.bsdf).coats;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Illumination light = illumination(scene_.lights[i], hit.point);
    const double lambert = glm::dot(light.direction, normal);
    if (!(lambert > 0.0) || light.strength == 0.0) continue;
    const RayState towards_lamp{{hit.point, light.direction}, hit.same_side, hit.nesting_before};
    const float* arriving = shadow_rays_.transmittance(towards_lamp, light.distance, bundle.first,
                                                       bundle.last, wavelengths_, counts);
    if (!arriving) continue;
    for (int b = bundle.first; b < bundle.last; ++b)
      lit_[static_cast<std::size_t>(b)] = throughput_[static_cast<std::size_t>(b)] * arriving[b];
    const int source = plan_.light_source(i);
    if (coated && !diffuse.zero())
      sums.add(source,
               diffuse_under_coat(bundle, material, diffuse,
                                  std::min(1.0, glm::dot(to_eye, normal)), std::min(1.0, lambert)),
               ones_, static_cast<float>(light.strength * std::numbers::pi), bundle.first,
               bundle.last);
    else if (!diffuse.zero())
      sums.add(source, lit_.data(), diffuse, static_cast<float>(light.strength * lambert),
               bundle.first, bundle.last);
    if (material.phong.present()) {
      const dvec3 half = glm::normalize(to_eye + light.direction);
      const double phong = material.phong.strength(glm::dot(half, normal));
      sums.add(source, lit_.data(), material.phong.reflectance,
               static_cast<float>(light.strength * phong), bundle.first, bundle.last);
    }
  }
}

/// How much of what it meets a branch brings to the picture: `most`, the largest throughput of its
/// bands, times n^2 of the medium it goes through, since radiance there is n^2 times that outside.
double Whitted::importance(float most, int first, MediumId medium) {
  const double n = wavelengths_.indices(medium)[first];
  return static_cast<double>(most) * n * n;
}

/// The chance that a branch is followed: narrow and faint ones would cost as much as they add
/// little. A branch matters in proportion to its importance and to its share of the bands.
double Whitted::chance(double importance, BandRange bands) const {
  if (plan_.follows_all()) return 1.0;
  const double sub_bundles = importance * plan_.shares.of(bands) * plan_.settings.max_fan;
  return std::min(1.0, sub_bundles / kSurePart);
}

void Whitted::scatter(const Bundle& bundle, const MaterialPlan& material, double choice,
                      RayCounts& counts) {
  const BsdfFacts facts = facts_of(material.bsdf);
  if (!facts.reflects && !facts.transmits) return;
  const Hit& hit = bundle.hit;
  Incidence in = surface_incidence(material.bsdf, hit, {bundle.first, bundle.last}, wavelengths_);
  in.wo = {0.0, 0.0, std::abs(glm::dot(hit.normal, bundle.state.ray.direction))};
  specular_factors(material.bsdf, in, {reflected_.data(), transmitted_.data()});
  if (facts.reflects) reflect(bundle, reflected_.data(), counts);
  if (facts.transmits) refract(bundle, choice, counts);
}

void Whitted::reflect(const Bundle& bundle, const float* factors, RayCounts& counts) {
  const Hit& hit = bundle.hit;
  const double brought =
      importance(largest_product(throughput_.data(), factors, bundle.first, bundle.last),
                 bundle.first, hit.medium_before);
  if (!(brought > plan_.settings.min_throughput)) return;
  const double survives = chance(brought, {bundle.first, bundle.last});
  if (survives < 1.0 && decisions_.next() >= survives) return;
  for (int b = bundle.first; b < bundle.last; ++b)
    lit_[static_cast<std::size_t>(b)] = throughput_[static_cast<std::size_t>(b)] * factors[b];
  Bundle& next = push(bundle.first, bundle.last, lit_.data(), static_cast<float>(1.0 / survives));
  next.density = bundle.density;
  set_off(bundle, reflected(bundle.state.ray.direction, hit.entering ? hit.normal : -hit.normal),
          false, next);
  world_.find_closest(next.state, next.hit);
  counts.add(RayKind::reflected, next.state);
}

void Whitted::refract(const Bundle& bundle, double choice, RayCounts& counts) {
  for (int b = bundle.first; b < bundle.last; ++b)
    lit_[static_cast<std::size_t>(b)] =
        throughput_[static_cast<std::size_t>(b)] * transmitted_[static_cast<std::size_t>(b)];
  // Bands under total reflection, and those without power, have no refracted ray. What remains is
  // one run of bands as a rule, and more where n(lambda) turns.
  const auto passes = [&](int b) { return lit_[static_cast<std::size_t>(b)] > 0.0f; };
  for (int first = bundle.first; first < bundle.last;) {
    if (!passes(first)) {
      ++first;
      continue;
    }
    int last = all_above_zero(lit_.data(), first, bundle.last) ? bundle.last : first + 1;
    while (last < bundle.last && passes(last))
      ++last;
    const double brought =
        importance(largest_of(lit_.data(), first, last), first, bundle.hit.medium_after);
    if (brought > plan_.settings.min_throughput)
      for (const FanCell& cell :
           fan_.refract(bundle, first, last, brought, wavelengths_, choice, counts))
        go_on_as(cell, bundle, push(cell.first, cell.last, lit_.data(), cell.weight));
    first = last;
  }
}

} // namespace abbe
