#include "core/lamps/emission.h"

#include "core/emitters/cone.h"
#include "core/emitters/illumination.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {
namespace {

constexpr double kPi = std::numbers::pi;

Cone cone_of(const SpotLight& spot) {
  const double s = std::sin(0.5 * spot.half_angle);
  return {spot.axis, 2.0 * s * s};
}

/// True when the cones have a direction in common.
bool overlap(const Cone& a, const Cone& b) {
  const auto half_angle = [](const Cone& c) {
    return std::acos(std::clamp(1.0 - c.one_minus_cos, -1.0, 1.0));
  };
  const double between = std::acos(std::clamp(glm::dot(a.axis, b.axis), -1.0, 1.0));
  return between <= half_angle(a) + half_angle(b);
}

} // namespace

bool endless_flux(const Light& light) {
  return light.falloff == Falloff::none &&
         !std::holds_alternative<DirectionalLight>(light.emitter) &&
         !std::holds_alternative<SunLight>(light.emitter);
}

Emission::Emission(const Scene& scene, const Plan& plan)
    : shape_emits_(scene.shapes.size(), false) {
  targets_ = specular_targets(scene, plan);
  const std::vector<EmissionTarget>& targets = targets_;
  if (targets.empty()) return;
  const auto parallel = std::make_shared<const ParallelTargets>(scene, plan);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const double value = band_mean(light.spectrum, plan.grid);
    Emitter emitter;
    emitter.scene_ = &scene;
    emitter.light_ = static_cast<int>(i);
    emitter.source_ = plan.light_source(i);
    emitter.targets_ = targets;
    if (const auto* point = std::get_if<PointLight>(&light.emitter)) {
      if (endless_flux(light)) continue;
      emitter.flux_ = value * solid_angles(targets, point->position);
    } else if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) {
      if (endless_flux(light)) continue;
      const Cone cone = cone_of(*spot);
      std::erase_if(emitter.targets_, [&](const EmissionTarget& t) {
        return !overlap(cone, cone_to_ball(spot->position, t.center, t.radius));
      });
      emitter.flux_ =
          value * std::min(cone.solid_angle(), solid_angles(emitter.targets_, spot->position));
    } else {
      emitter.parallel_ = parallel;
      emitter.flux_ = value * kPi * parallel->area();
    }
    if (emitter.flux_ > 0.0 && !emitter.targets_.empty()) emitters_.push_back(std::move(emitter));
  }
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const PlacedShape& placed = scene.shapes[i];
    if (!placed.material.valid() || !can_sample_surface(placed.shape)) continue;
    const MaterialPlan& material = plan.materials[placed.material.index()];
    if (material.emission_source < 0) continue;
    const double value = band_mean(scene.materials[placed.material.index()].emission, plan.grid);
    if (!(value > 0.0)) continue;
    Emitter emitter;
    emitter.scene_ = &scene;
    emitter.shape_ = {static_cast<std::int32_t>(i)};
    emitter.one_sided_ = is_solid(placed.shape) || !material.emits_behind;
    emitter.source_ = material.emission_source;
    emitter.targets_ = targets;
    emitter.surface_ = sampled_surface(placed, material.emits_behind);
    const double area = std::visit([](const auto& s) { return s.area(); }, *emitter.surface_);
    const Bounds box = bounds(placed);
    emitter.flux_ =
        value * area * std::min(kPi, solid_angles(targets, 0.5 * (box.lower + box.upper)));
    shape_emits_[i] = true;
    emitters_.push_back(std::move(emitter));
  }
}

void Emission::place(const World& world) {
  for (Emitter& emitter : emitters_) {
    if (emitter.light_ >= 0) {
      const Light& light = emitter.scene_->lights[static_cast<std::size_t>(emitter.light_)];
      if (const auto* point = std::get_if<PointLight>(&light.emitter))
        emitter.nesting_ = world.nesting_at(point->position);
      else if (const auto* spot = std::get_if<SpotLight>(&light.emitter))
        emitter.nesting_ = world.nesting_at(spot->position);
      continue;
    }
    // Just the solids around the shape: its own inside does not count.
    for (const ShapeId id : world.nesting_at(emitter.surface_point({0.5, 0.5}).point))
      if (id != emitter.shape_) emitter.nesting_.push_back(id);
  }
}

bool Emission::emits(ShapeId shape) const {
  return shape_emits_[shape.index()];
}

std::vector<std::uint32_t> Emission::shares(std::uint32_t paths) const {
  double total = 0.0;
  for (const Emitter& emitter : emitters_)
    total += emitter.flux_;
  std::vector<std::uint32_t> result;
  for (const Emitter& emitter : emitters_)
    result.push_back(
        std::max(1u, static_cast<std::uint32_t>(std::llround(paths * (emitter.flux_ / total)))));
  return result;
}

std::optional<EmittedRay> Emitter::sample(const Sampler& sampler) const {
  if (light_ < 0) return from_shape(sampler);
  const Light& light = scene_->lights[static_cast<std::size_t>(light_)];
  if (const auto* point = std::get_if<PointLight>(&light.emitter))
    return from_point(point->position, sampler);
  if (const auto* spot = std::get_if<SpotLight>(&light.emitter)) return from_spot(*spot, sampler);
  if (const auto* sun = std::get_if<SunLight>(&light.emitter)) return from_sun(*sun, sampler);
  return from_afar(std::get<DirectionalLight>(light.emitter).direction, sampler);
}

std::optional<EmittedRay> Emitter::from_point(const dvec3& position, const Sampler& sampler) const {
  const DirectionSample way = towards(targets_, position, sampler.pair(kEmissionDirection));
  EmittedRay ray;
  ray.state.ray = {position, way.direction};
  ray.state.nesting = nesting_;
  ray.source = source_;
  ray.flux = 1.0 / way.density;
  return ray;
}

std::optional<EmittedRay> Emitter::from_spot(const SpotLight& spot, const Sampler& sampler) const {
  const Cone cone = cone_of(spot);
  const dvec2 u = sampler.pair(kEmissionDirection);
  DirectionSample way{};
  if (cone.solid_angle() <= solid_angles(targets_, spot.position))
    way = {cone.sample(u), 1.0 / cone.solid_angle()};
  else
    way = towards(targets_, spot.position, u);
  const double shine = brightness_towards(spot, way.direction);
  if (!(shine > 0.0)) return std::nullopt;
  EmittedRay ray;
  ray.state.ray = {spot.position, way.direction};
  ray.state.nesting = nesting_;
  ray.source = source_;
  ray.flux = shine / way.density;
  return ray;
}

/// A direction of the disc, and parallel light along it.
std::optional<EmittedRay> Emitter::from_sun(const SunLight& sun, const Sampler& sampler) const {
  const double sine = std::sin(sun.angular_radius);
  const Cone disc = Cone::of_sine(sun.direction, sine * sine);
  auto ray = from_afar(disc.sample(sampler.pair(kEmissionDirection)), sampler);
  // Irradiance: the disc's radiance times its solid angle, where from_afar took pi.
  ray->flux *= sun.radiance_per_value() / disc.density() / kPi;
  return ray;
}

std::optional<EmittedRay> Emitter::from_afar(const dvec3& direction, const Sampler& sampler) const {
  const ParallelSample line = parallel_->sample(direction, sampler.pair(kEmissionPoint));
  EmittedRay ray;
  ray.state.ray = {line.place, direction};
  ray.source = source_;
  ray.flux = kPi / line.density;
  return ray;
}

SurfacePoint Emitter::surface_point(const dvec2& u) const {
  return std::visit([&](const auto& s) { return s.at(u); }, *surface_);
}

std::optional<EmittedRay> Emitter::from_shape(const Sampler& sampler) const {
  const SurfacePoint at = surface_point(sampler.pair(kEmissionPoint));
  const DirectionSample way = towards(targets_, at.point, sampler.pair(kEmissionDirection));
  const double cosine = glm::dot(way.direction, at.normal);
  if (one_sided_ ? !(cosine > 0.0) : cosine == 0.0) return std::nullopt;
  EmittedRay ray;
  ray.state.ray = {at.point, way.direction};
  ray.state.contacts.push_back({shape_, at.face, cosine > 0.0 ? Side::outside : Side::inside});
  ray.state.nesting = nesting_;
  ray.source = source_;
  ray.flux = std::abs(cosine) / (at.density * way.density);
  return ray;
}

} // namespace abbe
