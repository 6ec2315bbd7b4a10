#include "core/bsdfs/rough_dielectric.h"

#include "core/optics/dielectric_facets.h"

#include <algorithm>

namespace abbe {
namespace {

DielectricFacets facets(const RoughDielectric& surface, Transport transport) {
  return {Ggx::from_roughness(surface.roughness), surface.albedo ? &*surface.albedo : nullptr,
          transport};
}

} // namespace

BsdfFacts RoughDielectric::facts() const {
  BsdfFacts facts = facet.facts();
  facts.rough = true;
  return facts;
}

double RoughDielectric::evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const {
  return evaluate_dielectric_facets(facets(*this, in.transport), facet.optics(in), in.wo, wi,
                                    in.live_bands(), f_cos);
}

std::optional<dvec3> RoughDielectric::sample(const Incidence& in, const dvec2& u,
                                             const dvec2& lobe) const {
  return sample_dielectric_facets(facets(*this, in.transport), facet.optics(in), in.wo,
                                  in.live_band(lobe.y), u, lobe.x);
}

void RoughDielectric::find_albedo(double largest_ratio) {
  if (compensation && largest_ratio > 1.0)
    albedo.emplace(Ggx::from_roughness(roughness), std::max(largest_ratio, 1.01));
}

} // namespace abbe
