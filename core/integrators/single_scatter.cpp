#include "core/integrators/single_scatter.h"

#include "core/integrators/absorption.h"
#include "core/lights/illumination.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abbe {

SingleScatter::SingleScatter(const Scene& scene, const Plan& plan, const World& world)
    : scene_(scene), plan_(plan), world_(world), shadow_rays_(plan, world),
      ones_(1.0f, plan.grid.count()), seen_(plan.stride), lit_(plan.stride) {}

void SingleScatter::add(const RayState& state, double way, MediumId medium, int first, int last,
                        const float* throughput, PathWavelengths& wavelengths, RadianceSums& sums,
                        RayCounts& counts) {
  const MediumPlan& filling = plan_.medium(medium);
  if (!filling.drops) return;
  const DropsPlan& drops = *filling.drops;
  const double extinction = drops.extinction_per_unit;
  const double scattered = -std::expm1(-extinction * way); // of a ray that goes all the way
  if (!(scattered > 0.0)) return;
  const double distance = -std::log1p(-place_ * scattered) / extinction;
  const dvec3 point = state.ray.at(distance);
  // The ray may have passed boundaries that do not show, so its own nesting need not hold here.
  const Nesting nesting = world_.nesting_at(point);
  std::copy(throughput + first, throughput + last, seen_.begin() + first);
  absorb(filling, distance, first, last, seen_.data());
  // s exp(-s t) over the density of the place; `absorb` has applied exp(-s t) already.
  const double weight = scattered * std::exp(extinction * distance);

  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const Illumination light = illumination(scene_.lights[i], point);
    if (light.strength == 0.0) continue;
    const auto& phase = std::isinf(light.distance) ? drops.under_sun : drops.under_lamp;
    const RayState towards_lamp{{point, light.direction}, {}, nesting};
    const float* arriving =
        shadow_rays_.transmittance(towards_lamp, light.distance, first, last, wavelengths, counts);
    if (!arriving) continue;
    const auto part = phase->at(glm::dot(light.direction, state.ray.direction));
    for (int b = first; b < last; ++b) {
      const auto k = static_cast<std::size_t>(b);
      lit_[k] = seen_[k] * arriving[b] * part[b];
    }
    const double irradiance = std::numbers::pi * light.strength;
    sums.add(plan_.light_source(i), lit_.data(), ones_, static_cast<float>(weight * irradiance),
             first, last);
  }
}

} // namespace abbe
