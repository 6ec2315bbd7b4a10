#include "core/lights/lamps.h"

#include "core/lights/illumination.h"
#include "core/plan_extent.h"
#include "geometry/surface_sample.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

/// Mean over the bands: colours that the eye hardly sees are light too.
double mean_of(const Curve& spectrum, const BandGrid& grid) {
  double sum = 0.0;
  for (const double value : band_means(grid, spectrum))
    sum += value;
  return sum / grid.count();
}

} // namespace

Lamps::Lamps(const Scene& scene, const Plan& plan)
    : scene_(scene), plan_(plan), lamp_of_shape_(scene.shapes.size(), -1) {
  add_lights();
  add_shapes();
  share_chances();
}

void Lamps::add_lights() {
  // Light that does not fall off crosses the whole scene; its flux is that through a disc about it.
  const double radius = 0.5 * scene_size(scene_);
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Light& light = scene_.lights[i];
    const double value = mean_of(light.spectrum, plan_.grid);
    const double flux =
        light.falloff == Falloff::none ? kPi * kPi * radius * radius * value : 4.0 * kPi * value;
    if (!(flux > 0.0)) continue;
    Lamp lamp;
    lamp.light = static_cast<int>(i);
    lamp.source = plan_.light_source(i);
    lamp.power = flux;
    lamps_.push_back(lamp);
  }
}

void Lamps::add_shapes() {
  for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
    const PlacedShape& placed = scene_.shapes[i];
    if (!placed.material.valid() || !can_sample_surface(placed.shape)) continue;
    const std::size_t material = placed.material.index();
    if (plan_.materials[material].emission_source < 0) continue;
    Lamp lamp;
    lamp.shape = {static_cast<std::int32_t>(i)};
    lamp.source = plan_.materials[material].emission_source;
    lamp.power =
        kPi * surface_area(placed) * mean_of(scene_.materials[material].emission, plan_.grid);
    if (!(lamp.power > 0.0)) continue;
    lamp_of_shape_[i] = static_cast<int>(lamps_.size());
    lamps_.push_back(lamp);
  }
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
  return chosen->light >= 0 ? sample_light(*chosen, place) : sample_shape(*chosen, place, u);
}

std::optional<LampSample> Lamps::sample_light(const Lamp& lamp, const dvec3& place) const {
  const Illumination seen =
      illumination(scene_.lights[static_cast<std::size_t>(lamp.light)], place);
  if (!(seen.strength > 0.0)) return std::nullopt;
  return LampSample{seen.direction, seen.distance, 0.0, kPi * seen.strength / lamp.chance,
                    lamp.source};
}

std::optional<LampSample> Lamps::sample_shape(const Lamp& lamp, const dvec3& place,
                                              const dvec2& u) const {
  const PlacedShape& placed = scene_.shapes[lamp.shape.index()];
  const auto point = sample_surface(placed, u);
  const dvec3 way = point->point - place;
  const double distance2 = glm::dot(way, way);
  if (!(distance2 > 0.0)) return std::nullopt;
  const double distance = std::sqrt(distance2);
  const dvec3 direction = way / distance;
  const double facing = -glm::dot(direction, point->normal);
  const bool one_sided =
      is_solid(placed.shape) || !plan_.materials[placed.material.index()].emits_behind;
  const double cosine = one_sided ? facing : std::abs(facing);
  if (!(cosine > 0.0)) return std::nullopt;
  const double density = lamp.chance * point->density * distance2 / cosine;
  return LampSample{direction, distance, density, 1.0 / density, lamp.source};
}

double Lamps::density(const dvec3& place, const Hit& hit) const {
  const int index = lamp_of_shape_[hit.shape.index()];
  if (index < 0) return 0.0;
  const Lamp& lamp = lamps_[static_cast<std::size_t>(index)];
  if (!hit.entering && is_solid(scene_.shapes[lamp.shape.index()].shape)) return 0.0;
  const dvec3 way = hit.point - place;
  const double distance2 = glm::dot(way, way);
  const double cosine = std::abs(glm::dot(way, hit.normal)) / std::sqrt(distance2);
  if (!(cosine > 0.0)) return 0.0;
  return lamp.chance * surface_density(scene_.shapes[lamp.shape.index()], hit.normal) * distance2 /
         cosine;
}

} // namespace abbe
