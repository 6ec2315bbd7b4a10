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
    if (plan_.has_drops) break; // they are in the way, and stop no ray
    counts.add_any_hit(RayKind::shadow, towards_lamp, distance);
    return world_.occluded(towards_lamp, distance) ? nullptr : ones_.data();
  case ShadowRule::automatic: // never in a plan
  case ShadowRule::attenuated:
    break;
  }
  std::fill(transmittance_.begin(), transmittance_.end(), 1.0f);
  return attenuate(towards_lamp, distance, first, last, wavelengths, counts) ? transmittance_.data()
                                                                             : nullptr;
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
    // The way may end on a lamp that glows; whether it does, rounding must not decide.
    if (material.emission_source >= 0 && !world_.occluded(state, distance)) return true;
    if (!plan_.unseen(*hit)) {
      if (!material.transmits || plan_.settings.shadows == ShadowRule::opaque) return false;
      const double cos_i = std::min(1.0, std::abs(glm::dot(hit->normal, state.ray.direction)));
      attenuate_straight(material, cos_i, wavelengths.indices(hit->medium_before),
                         wavelengths.indices(hit->medium_after), first, last,
                         transmittance_.data());
    }
    state.ray.origin = hit->point;
    state.contacts = hit->other_side;
    state.nesting = hit->nesting_after;
    distance -= hit->t;
  }
}

} // namespace abbe
