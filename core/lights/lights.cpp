#include "core/lights/lights.h"

#include "core/lights/light_kinds.h"
#include "core/lights/scene_extent.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

using std::numbers::pi;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The area of a disc about the scene, through which goes what of distant light reaches it. A scene
/// without extent still has its lights.
double scene_disc(const Scene& scene) {
  const double size = scene_size(scene);
  return size > 0.0 ? 0.25 * pi * size * size : pi;
}

} // namespace

Lights::Lights(const Scene& scene, const Plan& plan)
    : scene_(scene), plan_(plan), ones_(1.0f, plan.grid.count()),
      light_of_shape_(scene.shapes.size(), -1) {
  add_lights();
  add_shapes();
  add_environment();
  share_chances();
}

void Lights::place(const World& world) {
  for (Choice& choice : choices_)
    if (auto* light = std::get_if<SurfaceLight>(&choice.extent))
      light->may_be_hidden = world.may_be_hidden(light->shape);
}

void Lights::add_lights() {
  const double around = scene_disc(scene_);
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Light& light = scene_.lights[i];
    Choice choice{PointOfLight{&light}, plan_.light_source(i)};
    choice.power = power(light, band_mean(light.spectrum, plan_.grid), around);
    if (!(choice.power > 0.0)) continue;
    if (const auto filled = disc(light)) {
      choice.extent = *filled;
      discs_.push_back(static_cast<int>(choices_.size()));
    }
    choices_.push_back(std::move(choice));
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
    const double area = std::visit([](const auto& s) { return s.area(); }, light.surface);
    const double sides = !light.solid && material.emits_behind ? 2.0 : 1.0;
    Choice choice{std::move(light), material.emission_source};
    choice.power = pi * sides * area * band_mean(scene_.materials[id].emission, plan_.grid);
    if (!(choice.power > 0.0)) continue;
    light_of_shape_[i] = static_cast<int>(choices_.size());
    choices_.push_back(std::move(choice));
  }
}

void Lights::add_environment() {
  if (!plan_.environment) return;
  Choice choice{EnvironmentLight{&*plan_.environment}, plan_.environment_source};
  choice.power = scene_disc(scene_) * plan_.environment->total() *
                 band_mean(scene_.environment->light, plan_.grid);
  if (!(choice.power > 0.0)) return;
  environment_ = static_cast<int>(choices_.size());
  choices_.push_back(std::move(choice));
}

void Lights::share_chances() {
  double total = 0.0;
  for (const Choice& choice : choices_)
    total += choice.power;
  double sum = 0.0;
  for (Choice& choice : choices_) {
    choice.chance = choice.power / total;
    sum += choice.power;
    choice.cumulative = sum / total;
  }
}

std::optional<LightSample> Lights::sample(const PointOfLight& light, const Choice& choice,
                                          const dvec3& place, const dvec2&) {
  const Illumination seen = illumination(*light.light, place);
  if (!(seen.strength > 0.0)) return std::nullopt;
  return LightSample{seen.direction, seen.distance, 0.0, pi * seen.strength / choice.chance,
                     choice.source};
}

std::optional<LightSample> Lights::sample(const LightDisc& disc, const Choice& choice, const dvec3&,
                                          const dvec2& u) {
  const double pdf = choice.chance * disc.directions.pdf();
  return LightSample{disc.directions.sample(u), kFar, pdf, disc.radiance / pdf, choice.source};
}

std::optional<LightSample> Lights::sample(const SurfaceLight& light, const Choice& choice,
                                          const dvec3& place, const dvec2& u) {
  const auto seen = std::visit([&](const auto& s) { return s.sample(place, u); }, light.surface);
  if (!seen) return std::nullopt;
  const double pdf = choice.chance * seen->pdf;
  return LightSample{seen->direction,
                     seen->distance,
                     pdf,
                     1.0 / pdf,
                     choice.source,
                     false,
                     light.may_be_hidden ? light.shape : ShapeId{}};
}

std::optional<LightSample> Lights::sample(const EnvironmentLight& light, const Choice& choice,
                                          const dvec3&, const dvec2& u) {
  const dvec3 direction = light.map->sample(u);
  const double pdf = choice.chance * light.map->pdf(direction);
  if (!(pdf > 0.0)) return std::nullopt;
  return LightSample{direction, kFar, pdf, 1.0 / pdf, choice.source, true};
}

std::optional<LightSample> Lights::sample(const dvec3& place, double choice, const dvec2& u) const {
  if (choices_.empty()) return std::nullopt;
  const auto chosen =
      std::upper_bound(choices_.begin(), choices_.end() - 1, choice,
                       [](double value, const Choice& c) { return value < c.cumulative; });
  return std::visit([&](const auto& extent) { return sample(extent, *chosen, place, u); },
                    chosen->extent);
}

double Lights::pdf(const dvec3& place, const Hit& hit) const {
  const int index = light_of_shape_[hit.shape.index()];
  if (index < 0) return 0.0;
  const Choice& choice = choices_[static_cast<std::size_t>(index)];
  const auto& light = std::get<SurfaceLight>(choice.extent);
  if (light.solid && !hit.entering) return 0.0;
  return choice.chance *
         std::visit([&](const auto& s) { return s.pdf(place, hit.point, hit.normal); },
                    light.surface);
}

bool Lights::sun_shows(const dvec3& direction) const {
  return std::ranges::any_of(discs_, [&](int i) {
    const Choice& choice = choices_[static_cast<std::size_t>(i)];
    return std::get<LightDisc>(choice.extent).directions.holds(direction);
  });
}

void Lights::add_sky(const dvec3& direction, double pdf, bool suns, BandSpan<float> throughput,
                     RadianceSums& sums) const {
  sums.add(Plan::kBackground, throughput, ones_, 1.0f);
  const auto weight = [&](double light_pdf) { return pdf > 0.0 ? pdf / (pdf + light_pdf) : 1.0; };
  for (const int i : discs_) {
    const Choice& choice = choices_[static_cast<std::size_t>(i)];
    const auto& disc = std::get<LightDisc>(choice.extent);
    if (!suns || !disc.directions.holds(direction)) continue;
    const double part = disc.radiance * weight(choice.chance * disc.directions.pdf());
    sums.add(choice.source, throughput, ones_, static_cast<float>(part));
  }
  if (environment_ < 0) return;
  const Choice& environment = choices_[static_cast<std::size_t>(environment_)];
  const double part =
      pdf > 0.0 ? weight(environment.chance * plan_.environment->pdf(direction)) : 1.0;
  plan_.environment->scale(direction, throughput);
  sums.add(environment.source, throughput, ones_, static_cast<float>(part));
}

} // namespace abbe
