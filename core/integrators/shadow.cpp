#include "core/integrators/shadow.h"

#include "core/integrators/absorption.h"
#include "core/materials/dielectric.h"

#include <algorithm>

namespace abbe {

ShadowRays::ShadowRays(const Plan& plan, const World& world)
    : plan_(plan), world_(world), ones_(plan.stride, 1.0f), transmittance_(plan.stride) {}

const float* ShadowRays::transmittance(const RayState& towards_lamp, double distance, int first,
                                       int last, PathWavelengths& wavelengths, RayCounts& counts) {
  switch (plan_.settings.shadows) {
  case ShadowRule::none:
    return ones_.data();
  case ShadowRule::opaque:
    counts.add_any_hit(RayKind::shadow, towards_lamp, distance);
    return world_.occluded(towards_lamp, distance) ? nullptr : ones_.data();
  case ShadowRule::automatic: // never in a plan
  case ShadowRule::attenuated:
    std::fill(transmittance_.begin(), transmittance_.end(), 1.0f);
    return attenuate(towards_lamp, distance, first, last, wavelengths, counts)
               ? transmittance_.data()
               : nullptr;
  }
  return nullptr;
}

bool ShadowRays::attenuate(RayState state, double distance, int first, int last,
                           PathWavelengths& wavelengths, RayCounts& counts) {
  for (;;) {
    counts.add(RayKind::shadow, state);
    const auto hit = world_.closest(state);
    const double way = hit ? std::min(hit->t, distance) : distance;
    const MediumId medium = hit ? hit->medium_before : world_.medium_of(state.nesting);
    absorb(plan_.medium(medium), way, first, last, transmittance_.data());
    if (!hit || hit->t >= distance) return true;
    const MaterialPlan& material = plan_.materials[hit->material.index()];
    if (!material.transmits) return false;
    const double cos_i = std::min(1.0, std::abs(glm::dot(hit->normal, state.ray.direction)));
    pass(material, cos_i, wavelengths.indices(hit->medium_before),
         wavelengths.indices(hit->medium_after), first, last, transmittance_);
    state.ray.origin = hit->point;
    state.contacts = hit->other_side;
    state.nesting = hit->nesting_after;
    distance -= hit->t;
  }
}

/// A mixture lets through the mean of what its parts do.
void ShadowRays::pass(const MaterialPlan& material, double cos_i, const double* n_before,
                      const double* n_after, int first, int last, std::vector<float>& light) {
  if (!material.mixed()) {
    if (material.transmits)
      attenuate_straight(material, cos_i, n_before, n_after, first, last, light.data());
    else
      std::fill(light.begin() + first, light.begin() + last, 0.0f);
    return;
  }
  const MixturePlan& mix = material.mixture;
  std::vector<float> other = light;
  pass(plan_.materials[static_cast<std::size_t>(mix.first)], cos_i, n_before, n_after, first, last,
       light);
  pass(plan_.materials[static_cast<std::size_t>(mix.second)], cos_i, n_before, n_after, first, last,
       other);
  const auto share = static_cast<float>(mix.share);
  for (int b = first; b < last; ++b) {
    const auto i = static_cast<std::size_t>(b);
    light[i] = share * light[i] + (1.0f - share) * other[i];
  }
}

} // namespace abbe
