#include "core/integrators/shadow.h"

#include "core/integrators/absorption.h"
#include "core/scattering/dielectric.h"
#include "core/scattering/material_optics.h"

#include <algorithm>

namespace abbe {

ShadowRays::ShadowRays(const Plan& plan, const World& world)
    : plan_(plan), world_(world), ones_(plan.stride, 1.0f), transmittance_(plan.stride) {}

const float* ShadowRays::transmittance(const RayState& towards_lamp, double distance, int first,
                                       int last, PathWavelengths& wavelengths, RayCounts& counts) {
  through_glass_ = false;
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
  Hit hit;
  Passage passage;
  for (;;) {
    counts.add(RayKind::shadow, state);
    // Of what lies at the end of the way nothing counts: rounding must not decide whether it does.
    world_.find_closest(state, distance, passage, hit);
    const double way = hit.met() ? hit.t : distance;
    const MediumId medium = hit.met() ? hit.medium_before : world_.medium_of(state.nesting);
    absorb(plan_.medium(medium), way, first, last, transmittance_.data());
    if (!hit.met()) return true;
    const MaterialPlan& material = plan_.materials[hit.material.index()];
    if (!plan_.unseen(hit)) {
      if (!material.transmits || plan_.settings.shadows == ShadowRule::opaque) return false;
      // The path tracer finds what comes through rough glass by scattering.
      if (material.roughness > 0.0 && plan_.settings.integrator == Integrator::path) return false;
      const double cos_i = std::min(1.0, std::abs(glm::dot(hit.normal, state.ray.direction)));
      pass(material, hit, cos_i, first, last, wavelengths, transmittance_);
      through_glass_ = true;
    }
    if (!passage.go_through(hit, state)) return false;
    distance -= hit.t;
  }
}

/// A mixture lets through the mean of what its parts do.
void ShadowRays::pass(const MaterialPlan& material, const Hit& hit, double cos_i, int first,
                      int last, PathWavelengths& wavelengths, std::vector<float>& light) {
  if (!material.mixed()) {
    if (!material.transmits)
      std::fill(light.begin() + first, light.begin() + last, 0.0f);
    else if (material.film >= 0)
      attenuate_straight(
          material_optics(material, hit.medium_before, hit.medium_after, wavelengths), cos_i, first,
          last, light.data());
    else
      attenuate_straight(material, cos_i, wavelengths.indices(hit.medium_before),
                         wavelengths.indices(hit.medium_after), first, last, light.data());
    return;
  }
  const MixturePlan& mix = material.mixture;
  std::vector<float> other = light;
  pass(plan_.materials[static_cast<std::size_t>(mix.first)], hit, cos_i, first, last, wavelengths,
       light);
  pass(plan_.materials[static_cast<std::size_t>(mix.second)], hit, cos_i, first, last, wavelengths,
       other);
  const auto share = static_cast<float>(mix.share);
  for (int b = first; b < last; ++b) {
    const auto i = static_cast<std::size_t>(b);
    light[i] = share * light[i] + (1.0f - share) * other[i];
  }
}

} // namespace abbe
