#include "core/lamps/lamps.h"

#include "core/emitters/illumination.h"
#include "core/scene/scene_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

/// In which a lamp shines; of a spotlight's soft edge half.
double solid_angle(const Light& light) {
  const auto* spot = std::get_if<SpotLight>(&light.emitter);
  if (!spot) return 4.0 * kPi;
  return 2.0 * kPi * (1.0 - std::cos(0.5 * (spot->full_angle + spot->half_angle)));
}

/// The area of a disc about the scene, through which goes what of distant light reaches it. A scene
/// without extent still has its lamps.
double scene_disc(const Scene& scene) {
  const double size = scene_size(scene);
  return size > 0.0 ? 0.25 * kPi * size * size : kPi;
}

} // namespace

Lamps::Lamps(const Scene& scene, const Plan& plan)
    : scene_(scene), plan_(plan), ones_(1.0f, plan.grid.count()),
      lamp_of_shape_(scene.shapes.size(), -1) {
  add_lights();
  add_shapes();
  add_environment();
  share_chances();
}

void Lamps::add_lights() {
  const double disc = scene_disc(scene_);
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Light& light = scene_.lights[i];
    const double value = band_mean(light.spectrum, plan_.grid);
    const double angle = solid_angle(light);
    const bool falls = light.falloff == Falloff::square;
    const double flux = falls ? angle * value : kPi * value * disc * std::min(1.0, angle / kPi);
    if (!(flux > 0.0)) continue;
    Lamp lamp;
    lamp.light = static_cast<int>(i);
    lamp.source = plan_.light_source(i);
    lamp.power = flux;
    if (const auto* sun = std::get_if<SunLight>(&light.emitter)) {
      const double sine = std::sin(sun->angular_radius);
      lamp.disc = Cone::of_sine(-sun->direction, sine * sine);
      lamp.radiance = sun->radiance_per_value();
      suns_.push_back(static_cast<int>(lamps_.size()));
    }
    lamps_.push_back(lamp);
  }
}

void Lamps::add_shapes() {
  for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
    const PlacedShape& placed = scene_.shapes[i];
    if (!placed.material.valid()) continue;
    const std::size_t material = placed.material.index();
    const MaterialPlan& finish = plan_.materials[material];
    if (finish.emission_source < 0 || !can_sample_surface(placed.shape)) continue;
    Lamp lamp;
    lamp.solid = is_solid(placed.shape);
    lamp.surface = sampled_surface(placed, finish.emits_behind);
    lamp.source = finish.emission_source;
    const double area = std::visit([](const auto& s) { return s.area(); }, *lamp.surface);
    const double sides = !lamp.solid && finish.emits_behind ? 2.0 : 1.0;
    lamp.power = kPi * sides * area * band_mean(scene_.materials[material].emission, plan_.grid);
    if (!(lamp.power > 0.0)) continue;
    lamp_of_shape_[i] = static_cast<int>(lamps_.size());
    lamps_.push_back(std::move(lamp));
  }
}

void Lamps::add_environment() {
  if (!plan_.environment) return;
  Lamp lamp;
  lamp.environment = true;
  lamp.source = plan_.environment_source;
  lamp.power = scene_disc(scene_) * plan_.environment->total() *
               band_mean(scene_.environment->light, plan_.grid);
  if (!(lamp.power > 0.0)) return;
  environment_ = static_cast<int>(lamps_.size());
  lamps_.push_back(std::move(lamp));
}

void Lamps::share_chances() {
  double total = 0.0;
  for (const Lamp& lamp : lamps_)
    total += lamp.power;
  double sum = 0.0;
  for (Lamp& lamp : lamps_) {
    lamp.chance = lamp.power / total;
    sum += lamp.power;
    lamp.cumulative = sum / total;
  }
}

std::optional<LampSample> Lamps::sample(const dvec3& place, double choice, const dvec2& u) const {
  if (lamps_.empty()) return std::nullopt;
  const auto chosen =
      std::upper_bound(lamps_.begin(), lamps_.end() - 1, choice,
                       [](double value, const Lamp& lamp) { return value < lamp.cumulative; });
  if (chosen->environment) {
    const dvec3 direction = plan_.environment->sample(u);
    const double density = chosen->chance * plan_.environment->density(direction);
    if (!(density > 0.0)) return std::nullopt;
    return LampSample{direction,      std::numeric_limits<double>::infinity(),
                      density,        1.0 / density,
                      chosen->source, true};
  }
  if (chosen->disc) {
    const double density = chosen->chance * chosen->disc->density();
    return LampSample{chosen->disc->sample(u), std::numeric_limits<double>::infinity(), density,
                      chosen->radiance / density, chosen->source};
  }
  if (chosen->light >= 0) return sample_light(*chosen, place);
  const auto seen = std::visit([&](const auto& s) { return s.sample(place, u); }, *chosen->surface);
  if (!seen) return std::nullopt;
  const double density = chosen->chance * seen->density;
  return LampSample{seen->direction, seen->distance, density, 1.0 / density, chosen->source};
}

std::optional<LampSample> Lamps::sample_light(const Lamp& lamp, const dvec3& place) const {
  const Illumination seen =
      illumination(scene_.lights[static_cast<std::size_t>(lamp.light)], place);
  if (!(seen.strength > 0.0)) return std::nullopt;
  return LampSample{seen.direction, seen.distance, 0.0, kPi * seen.strength / lamp.chance,
                    lamp.source};
}

double Lamps::density(const dvec3& place, const Hit& hit) const {
  const int index = lamp_of_shape_[hit.shape.index()];
  if (index < 0) return 0.0;
  const Lamp& lamp = lamps_[static_cast<std::size_t>(index)];
  if (lamp.solid && !hit.entering) return 0.0;
  return lamp.chance *
         std::visit([&](const auto& s) { return s.density(place, hit.point, hit.normal); },
                    *lamp.surface);
}

void Lamps::add_sky(const dvec3& direction, double density, bool suns, float* throughput, int first,
                    int last, RadianceSums& sums) const {
  sums.add(Plan::kBackground, throughput, ones_, 1.0f, first, last);
  const auto weight = [&](double lamp_density) {
    return density > 0.0 ? density / (density + lamp_density) : 1.0;
  };
  for (const int i : suns_) {
    const Lamp& sun = lamps_[static_cast<std::size_t>(i)];
    if (!suns || !sun.disc->holds(direction)) continue;
    const double part = sun.radiance * weight(sun.chance * sun.disc->density());
    sums.add(sun.source, throughput, ones_, static_cast<float>(part), first, last);
  }
  if (environment_ < 0) return;
  const Lamp& environment = lamps_[static_cast<std::size_t>(environment_)];
  const double part =
      density > 0.0 ? weight(environment.chance * plan_.environment->density(direction)) : 1.0;
  plan_.environment->scale(direction, first, last, throughput);
  sums.add(environment.source, throughput, ones_, static_cast<float>(part), first, last);
}

} // namespace abbe
