#include "core/bsdfs/rough_conductor.h"

#include "core/optics/conductor_facets.h"

namespace abbe {
namespace {

ConductorFacets facets(const RoughConductor& surface) {
  return {Ggx::from_roughness(surface.roughness), surface.albedo ? &*surface.albedo : nullptr};
}

} // namespace

BsdfLayer RoughConductor::layer() const {
  return std::visit([](const auto& smooth) { return smooth.layer(); }, facet);
}

void RoughConductor::specular(const Incidence& in, const SpecularFactors& out) const {
  std::visit([&](const auto& smooth) { smooth.specular(in, out); }, facet);
}

double RoughConductor::evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const {
  const SurfaceOptics optics =
      std::visit([&](const auto& smooth) { return smooth.optics(in); }, facet);
  return evaluate_conductor_facets(facets(*this), optics, in.wo, wi, in.live_bands(), f_cos);
}

std::optional<dvec3> RoughConductor::sample(const Incidence& in, const dvec2& u,
                                            const dvec2& lobe) const {
  return sample_conductor_facets(facets(*this), in.wo, u, lobe.x);
}

void RoughConductor::find_albedo(double) {
  if (compensation) albedo.emplace(Ggx::from_roughness(roughness));
}

} // namespace abbe
