#include "core/integrators/whitted.h"

#include "core/bands/band_math.h"
#include "core/bands/passing_runs.h"
#include "core/integrators/straight_on.h"
#include "core/integrators/tree_growth.h"
#include "core/lights/light_kinds.h"
#include "core/scattering/hit_material.h"
#include "core/scattering/surface_incidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

/// A branch is followed for sure when it matters at least as much as this part of one of the
/// `max_fan` sub-bundles. Chosen by time against error on scenes/lens and scenes/prism_view, see
/// docs/decisions/bundles.md.
constexpr double kSurePart = 1.0 / 16.0;

/// Where all bands are followed and the scene's threshold is 0, this importance is the first
/// threshold of large trees.
constexpr double kFaint = 1e-3;

} // namespace

Whitted::Whitted(const Scene& scene, const Plan& plan, const World& world, const Lights& lights,
                 double pixel_angle)
    : CameraIntegrator(plan), BundleWalk(plan, world, pixel_angle, Transport::radiance),
      scene_(scene), shadow_rays_(plan, world), single_scatter_(scene, plan, world),
      sky_(plan, lights), reflected_(plan.stride), transmitted_(plan.stride),
      textured_(0.0f, plan.grid.count()), lit_(plan.stride), coated_(plan.stride) {}

void Whitted::start(const CameraPaths& paths, std::size_t i) {
  paths.begin(i, bundle());
  sky_.begin_path(bundle().state.ray.direction);
  const BandSpan<float> row = throughput();
  for (int b = row.bands.first; b < row.bands.last; ++b)
    row[b] = plan_.live[static_cast<std::size_t>(b)] * paths.bundles[i].weight;
  wait();
}

/// Does a step of a path beyond the depth limit: with its own decisions, counts and sums.
template <class Step>
void Whitted::aside(Step&& step) {
  RayCounts* const counts = std::exchange(counts_, &beyond_.rays);
  std::swap(decisions_, beyond_.decisions);
  step();
  std::swap(decisions_, beyond_.decisions);
  counts_ = counts;
}

bool Whitted::trace(const CameraPaths& paths, const Sampler& sampler, RadianceSums& sums,
                    RayCounts& counts) {
  beyond_.begin_path(sampler);
  decisions_ = sampler.decisions();
  begin_path(sampler.pair(kWavelength), counts);
  single_scatter_.begin_path(sampler, wavelengths_, sums, counts);
  for (std::size_t i = paths.count; i-- > 0;) {
    start(paths, i);
    while (take()) {
      if (end_check_.gives_up()) {
        give_up();
        return false;
      }
      if (bundle().depth > beyond_.limit) [[unlikely]] {
        aside([&] {
          single_scatter_.send_to(beyond_.sums, beyond_.rays);
          extend();
          shade_ray(beyond_.sums, beyond_.rays);
          single_scatter_.send_to(sums, counts);
        });
        continue;
      }
      extend();
      shade_ray(sums, counts);
    }
  }
  return true;
}

void Whitted::shade_ray(RadianceSums& sums, RayCounts& counts) {
  if (!single_scatter_.arrive(bundle(), throughput())) return wait();
  if (sums.divided()) [[unlikely]]
    sums.classify(bundle().view, Arrival::direct);
  if (!bundle().hit.met()) return sky_.add(bundle(), {}, throughput(), sums);
  const MaterialPlan* material = &plan_.materials[bundle().hit.material.index()];
  if (material->mixture) material = &part_of(plan_, *material, decisions_.next());
  shade(bundle(), *material, sums, counts);
  scatter(bundle(), *material);
}

void Whitted::shade(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                    RayCounts& counts) {
  const auto add = [&](int source, const BandTable& factor) {
    sums.add(source, throughput(), factor, 1.0f);
  };
  const Hit& hit = bundle.hit;
  if (material.emits(hit)) add(material.emission_source, ones_);
  if (!material.ambient.zero()) {
    const auto classify = [&](Arrival arrival) {
      if (sums.divided()) [[unlikely]]
        sums.classify(bundle.view, arrival);
    };
    classify(Arrival::indirect);
    add(Plan::kAmbient, material.ambient);
    classify(Arrival::direct);
  }
  if (material.lit()) add_lights(bundle, material, sums, counts);
}

/// What arrives of a light's light, `lit_`, sent back by a coated ground, with Lambert's cosine.
/// The thesis's lights give pi times the light that a diffuse surface of theirs would need.
BandSpan<const float> Whitted::diffuse_under_coat(const Bundle& bundle,
                                                  const MaterialPlan& material,
                                                  const BandTable& diffuse, double cos_o,
                                                  double cos_i) {
  const auto at = [](double mu) { return dvec3{std::sqrt(std::max(0.0, 1.0 - mu * mu)), 0.0, mu}; };
  Incidence in = surface_incidence(material.bsdf, bundle.hit, bundle.bands, wavelengths_);
  in.wo = at(cos_o);
  in.ground = diffuse.data();
  const BandSpan<float> coated{coated_.data(), bundle.bands};
  (void)evaluate(material.bsdf, in, at(cos_i), coated.data);
  for (int b = bundle.bands.first; b < bundle.bands.last; ++b)
    coated[b] *= lit_[static_cast<std::size_t>(b)];
  return coated;
}

void Whitted::add_lights(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                         RayCounts& counts) {
  const Hit& hit = bundle.hit;
  const BandTable& diffuse = diffuse_at(plan_, world_, material, hit, textured_);
  const dvec3 to_eye = -bundle.state.ray.direction;
  const dvec3 normal = hit.facing_shading_normal();
  const BandSpan<const float> carried = throughput();
  const BandSpan<float> lit{lit_.data(), bundle.bands};
  const bool coated = facts_of(material.bsdf).coats;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Illumination light = illumination(scene_.lights[i], hit.point);
    const double lambert = glm::dot(light.direction, normal);
    if (!(lambert > 0.0) || light.strength == 0.0) continue;
    if (hit.bent && !(glm::dot(light.direction, hit.facing_normal()) > 0.0)) continue;
    const RayState towards_light = hit.going_on(light.direction, false);
    const float* arriving = shadow_rays_.transmittance(towards_light, light.distance, bundle.bands,
                                                       wavelengths_, counts);
    if (!arriving) continue;
    for (int b = lit.bands.first; b < lit.bands.last; ++b)
      lit[b] = carried[b] * arriving[b];
    const int source = plan_.light_source(i);
    if (coated && !diffuse.zero())
      sums.add(source,
               diffuse_under_coat(bundle, material, diffuse,
                                  std::min(1.0, glm::dot(to_eye, normal)), std::min(1.0, lambert)),
               ones_, static_cast<float>(light.strength * std::numbers::pi));
    else if (!diffuse.zero())
      sums.add(source, lit, diffuse, static_cast<float>(light.strength * lambert));
    if (material.phong.present()) {
      const dvec3 half = glm::normalize(to_eye + light.direction);
      const double phong = material.phong.strength(glm::dot(half, normal));
      sums.add(source, lit, material.phong.reflectance, static_cast<float>(light.strength * phong));
    }
  }
}

/// What a part of the light would bring from the medium in which it goes on.
double Whitted::brought(const float* factors, MediumId medium) {
  return importance(largest_product(throughput(), factors), bundle().bands.first, medium);
}

/// The chance with which all of a tree's branches are followed: faint ones at random.
double Whitted::faint_chance(double importance) const {
  if (!(importance > 0.0)) return 0.0;
  const double least = plan_.settings.min_throughput;
  return importance < least ? importance / least : 1.0;
}

/// The chance that a branch is followed: narrow ones too would cost as much as they add little. A
/// branch matters in proportion to its importance and to its share of the bands.
double Whitted::chance(double importance) const {
  const double faint = faint_chance(importance);
  if (plan_.follows_all()) return faint;
  const double sub_bundles = share(importance, bundle().bands) * plan_.settings.max_fan;
  return std::min(faint, sub_bundles / kSurePart);
}

/// The chance of a branch behind many surfaces.
double Whitted::deep_chance(double importance) const {
  const int surfaces = bundle().surfaces();
  const double least = plan_.settings.min_throughput;
  const double matters = plan_.follows_all() ? importance : share(importance, bundle().bands);
  const double first =
      plan_.follows_all() ? (least > 0.0 ? least : kFaint) : kSurePart / plan_.settings.max_fan;
  return std::min(1.0, matters / grown_threshold(std::max(first, least), surfaces));
}

void Whitted::scatter(const Bundle& bundle, const MaterialPlan& material) {
  BsdfFacts facts = facts_of(material.bsdf);
  lets_light_through_ = facts.transmits || facts.passes;
  // A pane is not counted, so the limit does not end what goes straight through.
  const bool ends = bundle.depth == beyond_.limit && (facts.reflects || facts.transmits);
  const bool followed = ends && beyond_.chosen();
  if (ends && !followed) facts.reflects = facts.transmits = false;
  if (!facts.reflects && !facts.transmits && !facts.passes) return;
  const Hit& hit = bundle.hit;
  Incidence in = surface_incidence(material.bsdf, hit, bundle.bands, wavelengths_);
  in.wo = {0.0, 0.0, std::abs(glm::dot(hit.shading_normal, bundle.state.ray.direction))};
  specular_factors(material.bsdf, in, {reflected_.data(), transmitted_.data()});
  if (!followed) return go_on(facts);
  BsdfFacts beyond = facts, within = facts;
  beyond.passes = within.reflects = within.transmits = false;
  aside([&] { go_on(beyond); });
  if (within.passes) go_on(within);
}

/// What goes on from the bundle's hit waits.
void Whitted::go_on(const BsdfFacts& facts) {
  if (bundle().surfaces() >= kSurfacesOfTree) return choose_branches(facts);
  if (facts.reflects) reflect();
  if (facts.transmits) refract();
  if (facts.passes) pass();
}

void Whitted::reflect() {
  const double survives = chance(brought(reflected_.data(), bundle().hit.medium_before));
  if (!(survives > 0.0) || (survives < 1.0 && decisions_.next() >= survives)) return;
  send_back(1.0 / survives);
}

void Whitted::send_back(double weight) {
  Bundle& next = branch_off_reflection(reflected_.data(), weight);
  if (!lets_light_through_) next.route = Route::opaque;
}

/// Straight on through a pane. Where the bundle has met as many surfaces as it may, this is still
/// done: a pane is not counted.
void Whitted::pass() {
  const double survives = faint_chance(brought(transmitted_.data(), bundle().hit.medium_after));
  if (!(survives > 0.0) || (survives < 1.0 && decisions_.next() >= survives)) return;
  go_straight_on(1.0 / survives);
}

/// The last step of a bundle: its throughput becomes what passes.
void Whitted::go_straight_on(double weight) {
  scale(transmitted_.data(), weight);
  ++bundle().panes;
  abbe::go_straight_on(bundle());
  wait();
}

/// The last step of a bundle: its throughput becomes what passes.
void Whitted::refract() {
  scale(transmitted_.data(), 1.0);
  const BandSpan<float> passing = throughput();
  for (const BandRange run : PassingRuns(passing)) {
    const double brought =
        importance(largest_of(passing.of(run)), run.first, bundle().hit.medium_after);
    const double survives = faint_chance(brought);
    if (survives < 1.0) {
      if (decisions_.next() >= survives) continue;
      const auto weight = static_cast<float>(1.0 / survives);
      for (int b = run.first; b < run.last; ++b)
        passing[b] *= weight;
    }
    branch_off_refraction(run, brought / survives);
  }
}

/// Behind many surfaces one number decides on both parts, so that one of them goes on wherever
/// their chances allow it: what goes on matters about as much as what came.
void Whitted::choose_branches(const BsdfFacts& facts) {
  const Hit& hit = bundle().hit;
  const double transmitted = facts.transmits || facts.passes
                                 ? deep_chance(brought(transmitted_.data(), hit.medium_after))
                                 : 0.0;
  const double reflected =
      facts.reflects ? deep_chance(brought(reflected_.data(), hit.medium_before)) : 0.0;
  const double u = reflected < 1.0 || transmitted < 1.0 ? decisions_.next() : 0.5;
  if (u < reflected) send_back(1.0 / reflected);
  if (u < 1.0 - transmitted || !(transmitted > 0.0)) return;
  if (facts.passes) return go_straight_on(1.0 / transmitted);
  scale(transmitted_.data(), 1.0 / transmitted);
  const BandSpan<const float> passing = throughput();
  for (const BandRange run : PassingRuns(passing))
    branch_off_refraction(run,
                          importance(largest_of(passing.of(run)), run.first, hit.medium_after));
}

} // namespace abbe
