#include "core/integrators/shadow.h"

#include "core/integrators/absorption.h"
#include "core/scattering/surface_incidence.h"

#include <algorithm>

namespace abbe {

ShadowRays::ShadowRays(const Plan& plan, const World& world)
    : plan_(plan), world_(world), ones_(plan.stride, 1.0f), transmittance_(plan.stride) {}

const float* ShadowRays::transmittance(const RayState& towards_light, double distance,
                                       BandRange bands, PathWavelengths& wavelengths,
                                       RayCounts& counts) {
  through_glass_ = false;
  if (plan_.settings.shadows == ShadowRule::none) return ones_.data();
  return along(towards_light, distance, bands, wavelengths, counts);
}

bool ShadowRays::hidden(const Ray& towards_light, const LightSample& light) const {
  return !world_.shows(light.may_be_hidden, light.hiders, towards_light, light.distance);
}

const float* ShadowRays::along(const RayState& state, double distance, BandRange bands,
                               PathWavelengths& wavelengths, RayCounts& counts) {
  through_glass_ = false;
  if (!through_refracting() && !plan_.dims_on_the_way()) {
    counts.add_any_hit(RayKind::shadow, state, distance);
    if (world_.occluded(state, distance)) return nullptr;
    const MediumPlan& medium = plan_.medium(world_.medium_of(state.nesting));
    if (!medium.absorbs) return ones_.data();
    // Nothing that shows is met, so all of the way is in this medium.
    std::fill(transmittance_.begin(), transmittance_.end(), 1.0f);
    absorb(medium, distance, {transmittance_.data(), bands});
    return transmittance_.data();
  }
  std::fill(transmittance_.begin(), transmittance_.end(), 1.0f);
  return attenuate(state, distance, bands, wavelengths, counts) ? transmittance_.data() : nullptr;
}

bool ShadowRays::attenuate(RayState state, double distance, BandRange bands,
                           PathWavelengths& wavelengths, RayCounts& counts) {
  const BandSpan<float> left{transmittance_.data(), bands};
  Hit hit;
  Passage passage;
  for (;;) {
    counts.add(RayKind::shadow, state);
    // What lies at the very end does not count: rounding must not decide whether it is met.
    world_.find_closest(state, distance, passage, hit);
    const double length = hit.met() ? hit.t : distance;
    const MediumId medium = hit.met() ? hit.medium_before : world_.medium_of(state.nesting);
    absorb(plan_.medium(medium), length, left);
    if (!hit.met()) return true;
    const MaterialPlan& material = plan_.materials[hit.material.index()];
    if (!plan_.unseen(hit)) {
      const BsdfFacts facts = material.facts();
      // The path tracer finds what comes through rough glass by scattering.
      const bool refracts = facts.transmits && through_refracting() &&
                            !(facts.rough && plan_.settings.integrator == Integrator::path);
      if (!refracts && !facts.passes) return false;
      const double cos_i =
          std::min(1.0, std::abs(glm::dot(hit.shading_normal, state.ray.direction)));
      pass(material, hit, cos_i, left, wavelengths);
      if (refracts) through_glass_ = true;
    }
    if (!passage.go_through(hit, state)) return false;
    distance -= hit.t;
  }
}

/// A mixture lets through the mean of what its parts do.
void ShadowRays::pass(const MaterialPlan& material, const Hit& hit, double cos_i,
                      BandSpan<float> light, PathWavelengths& wavelengths) {
  if (!material.mixture) {
    Incidence in = surface_incidence(material.bsdf, hit, light.bands, wavelengths);
    in.wo = {0.0, 0.0, cos_i};
    pass_straight(material.bsdf, in, light.data);
    return;
  }
  const MixturePlan& mix = *material.mixture;
  std::vector<float> row(light.data, light.data + plan_.stride);
  const BandSpan<float> other{row.data(), light.bands};
  pass(plan_.materials[static_cast<std::size_t>(mix.first)], hit, cos_i, light, wavelengths);
  pass(plan_.materials[static_cast<std::size_t>(mix.second)], hit, cos_i, other, wavelengths);
  const auto share = static_cast<float>(mix.share);
  for (int b = light.bands.first; b < light.bands.last; ++b)
    light[b] = share * light[b] + (1.0f - share) * other[b];
}

} // namespace abbe
