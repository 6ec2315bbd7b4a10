#include "core/lights/lights.h"

#include "core/lights/light_kinds.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

using std::numbers::pi;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The reach of a surface of radiance 1. A flat one shines along its normal; what has all normals,
/// or both sides of a flat one, shines to all sides: with a quarter of its area as a solid shows,
/// or half of it.
LightReach reach_of(const SampledSurface& surface, const Bounds& box) {
  const double area = std::visit([](const auto& s) { return s.area(); }, surface);
  const auto* flat = std::get_if<FlatSurface>(&surface);
  if (!flat) return {box, 0.25 * area, 0.0};
  if (flat->both_sides) return {box, 0.5 * area, 0.0};
  return LightReach(box, area, 0.0).along(flat->normal, 0.0, 0.5 * pi);
}

} // namespace

Lights::Lights(const Scene& scene, const Plan& plan)
    : scene_(scene), plan_(plan), ones_(1.0f, plan.grid.count()),
      light_of_shape_(scene.shapes.size(), -1) {
  add_lights();
  add_shapes();
  add_environment();
  std::vector<LightReach> reaches;
  for (const Choice& choice : choices_)
    reaches.push_back(choice.reach);
  hierarchy_ = LightHierarchy(reaches);
}

/// Lights are weighed by the bands that are seen. No light that shows in any of them counts 0.
double Lights::seen_mean(const Curve& spectrum) const {
  const std::vector<double> means = band_means(plan_.grid, spectrum);
  double sum = 0.0;
  for (int b = 0; b < plan_.grid.count(); ++b)
    sum += plan_.shares.of({b, b + 1}) * means[static_cast<std::size_t>(b)];
  return sum;
}

void Lights::add(Choice&& choice) {
  if (choice.reach.strength() > 0.0) choices_.push_back(std::move(choice));
}

void Lights::place(const World& world) {
  for (Choice& choice : choices_)
    if (auto* light = std::get_if<SurfaceLight>(&choice.extent))
      light->hiders = world.hiders(light->shape);
}

void Lights::add_lights() {
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Light& light = scene_.lights[i];
    const std::size_t before = choices_.size();
    const auto filled = disc(light);
    add({filled ? Extent(*filled) : Extent(PointOfLight{&light}), plan_.light_source(i),
         reach(light, seen_mean(light.spectrum))});
    if (filled && choices_.size() > before) discs_.push_back(static_cast<int>(before));
  }
}

void Lights::add_shapes() {
  for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
    const PlacedShape& placed = scene_.shapes[i];
    if (!placed.material.valid()) continue;
    const std::size_t id = placed.material.index();
    const MaterialPlan& material = plan_.materials[id];
    if (material.emission_source < 0 || !can_sample_surface(placed.shape)) continue;
    SurfaceLight light{*sampled_surface(placed, material.emits_behind),
                       is_solid(placed.shape),
                       {static_cast<std::int32_t>(i)}};
    const LightReach reach =
        reach_of(light.surface, bounds(placed)).times(seen_mean(scene_.materials[id].emission));
    const std::size_t before = choices_.size();
    add({std::move(light), material.emission_source, reach});
    if (choices_.size() > before) light_of_shape_[i] = static_cast<int>(before);
  }
}

void Lights::add_environment() {
  if (!plan_.environment) return;
  const LightReach reach =
      LightReach::distant(plan_.environment->total() * seen_mean(scene_.environment->light));
  const std::size_t before = choices_.size();
  add({EnvironmentLight{&*plan_.environment}, plan_.environment_source, reach});
  if (choices_.size() > before) environment_ = static_cast<int>(before);
}

std::optional<LightSample> Lights::sample(const PointOfLight& light, const Choice& choice,
                                          const dvec3& place, const dvec2&) {
  const Illumination seen = illumination(*light.light, place);
  if (!(seen.strength > 0.0)) return std::nullopt;
  return LightSample{seen.direction, seen.distance, 0.0, pi * seen.strength, choice.source};
}

std::optional<LightSample> Lights::sample(const LightDisc& disc, const Choice& choice, const dvec3&,
                                          const dvec2& u) {
  const double pdf = disc.directions.pdf();
  return LightSample{disc.directions.sample(u), kFar, pdf, disc.radiance / pdf, choice.source};
}

std::optional<LightSample> Lights::sample(const SurfaceLight& light, const Choice& choice,
                                          const dvec3& place, const dvec2& u) {
  const auto seen = std::visit([&](const auto& s) { return s.sample(place, u); }, light.surface);
  if (!seen) return std::nullopt;
  return LightSample{seen->direction,
                     seen->distance,
                     seen->pdf,
                     1.0 / seen->pdf,
                     choice.source,
                     false,
                     light.hiders.empty() ? ShapeId{} : light.shape,
                     light.hiders};
}

std::optional<LightSample> Lights::sample(const EnvironmentLight& light, const Choice& choice,
                                          const dvec3&, const dvec2& u) {
  const dvec3 direction = light.map->sample(u);
  const double pdf = light.map->pdf(direction);
  if (!(pdf > 0.0)) return std::nullopt;
  return LightSample{direction, kFar, pdf, 1.0 / pdf, choice.source, true};
}

std::optional<LightSample> Lights::sample(const dvec3& place, double choice, const dvec2& u) const {
  const auto chosen = single() ? LightHierarchy::Chosen{0, 1.0} : hierarchy_.choose(place, choice);
  if (!chosen) return std::nullopt;
  const Choice& light = choices_[static_cast<std::size_t>(chosen->light)];
  auto seen =
      std::visit([&](const auto& extent) { return sample(extent, light, place, u); }, light.extent);
  if (!seen) return std::nullopt;
  seen->pdf *= chosen->chance;
  seen->weight /= chosen->chance;
  return seen;
}

double Lights::pdf(const dvec3& place, const Hit& hit) const {
  const int index = light_of_shape_[hit.shape.index()];
  if (index < 0) return 0.0;
  const Choice& choice = choices_[static_cast<std::size_t>(index)];
  const auto& light = std::get<SurfaceLight>(choice.extent);
  if (light.solid && !hit.entering) return 0.0;
  return hierarchy_.chance(index, place) *
         std::visit([&](const auto& s) { return s.pdf(place, hit.point, hit.normal); },
                    light.surface);
}

bool Lights::sun_shows(const dvec3& direction) const {
  return std::ranges::any_of(discs_, [&](int i) {
    const Choice& choice = choices_[static_cast<std::size_t>(i)];
    return std::get<LightDisc>(choice.extent).directions.holds(direction);
  });
}

void Lights::add_sky(const LeavingRay& ray, LeftOut left_out, BandSpan<float> throughput,
                     RadianceSums& sums) const {
  sums.add(Plan::kBackground, throughput, ones_, 1.0f);
  const auto weight = [&](int choice, double light_pdf) {
    if (!(ray.pdf > 0.0)) return 1.0;
    return ray.pdf / (ray.pdf + hierarchy_.chance(choice, ray.place) * light_pdf);
  };
  for (const int i : discs_) {
    const Choice& choice = choices_[static_cast<std::size_t>(i)];
    const auto& disc = std::get<LightDisc>(choice.extent);
    if (left_out.suns || !disc.directions.holds(ray.direction)) continue;
    const double part = disc.radiance * weight(i, disc.directions.pdf());
    sums.add(choice.source, throughput, ones_, static_cast<float>(part));
  }
  if (environment_ < 0) return;
  const Choice& environment = choices_[static_cast<std::size_t>(environment_)];
  double part = weight(environment_, plan_.environment->pdf(ray.direction));
  if (left_out.bright) part *= 1.0 - plan_.environment->bright_share(ray.direction);
  plan_.environment->scale(ray.direction, throughput);
  sums.add(environment.source, throughput, ones_, static_cast<float>(part));
}

} // namespace abbe
