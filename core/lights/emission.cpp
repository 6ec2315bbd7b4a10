#include "core/lights/emission.h"

#include "core/lights/light_kinds.h"
#include "core/lights/specular_targets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace abbe {
namespace {

using std::numbers::pi;

SurfacePoint point_of(const SampledSurface& surface, const dvec2& u) {
  return std::visit([&](const auto& s) { return s.at(u); }, surface);
}

double area_of(const SampledSurface& surface) {
  return std::visit([](const auto& s) { return s.area(); }, surface);
}

} // namespace

Emission::Emission(const Scene& scene, const Plan& plan)
    : shape_emits_(scene.shapes.size(), false) {
  goals_.targets = specular_targets(scene, plan);
  if (goals_.targets.empty()) return;
  goals_.parallel = std::make_shared<const ParallelTargets>(parallel_targets(scene, plan));
  add_lights(scene, plan);
  add_shapes(scene, plan);
  add_sky(scene, plan);
}

void Emission::add_lights(const Scene& scene, const Plan& plan) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (endless_flux(light)) continue;
    EmittingLight emitting;
    emitting.origin_ = &light;
    emitting.source_ = plan.light_source(i);
    emitting.goals_ = goals_;
    emitting.flux_ = aim(light, band_mean(light.spectrum, plan.grid), emitting.goals_);
    if (emitting.flux_ > 0.0 && !emitting.goals_.targets.empty())
      lights_.push_back(std::move(emitting));
  }
}

void Emission::add_shapes(const Scene& scene, const Plan& plan) {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const PlacedShape& placed = scene.shapes[i];
    if (!placed.material.valid() || !can_sample_surface(placed.shape)) continue;
    const MaterialPlan& material = plan.materials[placed.material.index()];
    if (material.emission_source < 0) continue;
    const double value = band_mean(scene.materials[placed.material.index()].emission, plan.grid);
    if (!(value > 0.0)) continue;
    EmittingLight::EmittingShape shape{{static_cast<std::int32_t>(i)},
                                       *sampled_surface(placed, material.emits_behind),
                                       is_solid(placed.shape) || !material.emits_behind};
    const double area = area_of(shape.surface);
    const Bounds box = bounds(placed);
    EmittingLight emitting;
    emitting.origin_ = std::move(shape);
    emitting.source_ = material.emission_source;
    emitting.goals_ = goals_;
    emitting.flux_ =
        value * area * std::min(pi, solid_angles(goals_.targets, 0.5 * (box.lower + box.upper)));
    shape_emits_[i] = true;
    lights_.push_back(std::move(emitting));
  }
}

void Emission::add_sky(const Scene& scene, const Plan& plan) {
  if (!plan.environment || !plan.environment->has_bright()) return;
  EmittingLight emitting;
  emitting.origin_ = EmittingLight::BrightSky{&*plan.environment};
  emitting.source_ = plan.environment_source;
  emitting.goals_ = goals_;
  emitting.flux_ = band_mean(scene.environment->light, plan.grid) *
                   plan.environment->bright_total() * goals_.parallel->area();
  if (!(emitting.flux_ > 0.0)) return;
  sky_emits_ = true;
  lights_.push_back(std::move(emitting));
}

void Emission::place(const World& world) {
  for (EmittingLight& light : lights_) {
    light.world_ = &world;
    light.looks_about_ =
        !std::visit([&](const auto& origin) { return light.stands_alone(origin); }, light.origin_);
  }
}

/// Parallel light begins before all shapes. Any other light of the scene has one place.
bool EmittingLight::stands_alone(const Light* light) const {
  const auto place = position(*light);
  if (!place) return true;
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 direction(0.0);
    direction[axis] = 1.0;
    const RayState state = world_->start_at({*place, direction});
    if (!state.contacts.empty() || !state.nesting.empty()) return false;
  }
  return true;
}

bool EmittingLight::stands_alone(const EmittingShape& emitting) const {
  return world_->stands_alone(emitting.shape);
}

bool Emission::emits(ShapeId shape) const {
  return shape_emits_[shape.index()];
}

std::vector<std::uint32_t> Emission::shares(std::uint32_t paths) const {
  double total = 0.0;
  for (const EmittingLight& light : lights_)
    total += light.flux_;
  std::vector<std::uint32_t> result;
  for (const EmittingLight& light : lights_)
    result.push_back(
        std::max(1u, static_cast<std::uint32_t>(std::llround(paths * (light.flux_ / total)))));
  return result;
}

std::optional<EmittedRay> EmittingLight::sample(const Sampler& sampler) const {
  return std::visit([&](const auto& origin) { return from(origin, sampler); }, origin_);
}

std::optional<EmittedRay> EmittingLight::from(const Light* light, const Sampler& sampler) const {
  const auto emitted = emit(*light, goals_, sampler);
  if (!emitted) return std::nullopt;
  EmittedRay ray;
  if (looks_about_)
    ray.state = world_->start_at(emitted->ray);
  else
    ray.state.ray = emitted->ray;
  ray.source = source_;
  ray.flux = emitted->flux;
  return ray;
}

std::optional<EmittedRay> EmittingLight::from(const BrightSky& sky, const Sampler& sampler) const {
  const dvec3 direction = sky.map->sample_bright(sampler.pair(kEmissionDirection));
  const double pdf = sky.map->bright_pdf(direction);
  const double share = sky.map->bright_share(direction);
  if (!(pdf > 0.0) || share == 0.0) return std::nullopt;
  const LightRay parallel = parallel_ray(-direction, *goals_.parallel, sampler);
  EmittedRay ray;
  ray.state.ray = parallel.ray;
  ray.source = source_;
  // The irradiance is the radiance times the solid angle, where parallel_ray took pi.
  ray.flux = parallel.flux * share / pdf / pi;
  ray.environment = true;
  return ray;
}

std::optional<EmittedRay> EmittingLight::from(const EmittingShape& emitting,
                                              const Sampler& sampler) const {
  const SurfacePoint at = point_of(emitting.surface, sampler.pair(kEmissionPoint));
  const DirectionSample chosen =
      towards(goals_.targets, at.point, sampler.pair(kEmissionDirection));
  const double cosine = glm::dot(chosen.direction, at.normal);
  if (emitting.one_sided ? !(cosine > 0.0) : cosine == 0.0) return std::nullopt;
  EmittedRay ray;
  const SurfaceContact own{emitting.shape, at.face, cosine > 0.0 ? Side::outside : Side::inside};
  if (looks_about_) {
    auto start = world_->start_on(own, {at.point, chosen.direction});
    if (!start) return std::nullopt;
    ray.state = std::move(*start);
  } else {
    ray.state.ray = {at.point, chosen.direction};
    ray.state.contacts.push_back(own);
  }
  ray.source = source_;
  ray.flux = std::abs(cosine) / (at.pdf * chosen.pdf);
  return ray;
}

} // namespace abbe
