#include "core/bsdfs/coated_diffuse.h"

#include "core/bsdfs/diffuse.h"
#include "core/optics/coated_ground.h"

#include <numbers>

namespace abbe {
namespace {

CoatedGround ground(const CoatedDiffuse& surface, const Incidence& in) {
  CoatedGround coated{in.ground, std::nullopt, nullptr};
  if (surface.albedo) {
    coated.rough = Ggx::from_roughness(surface.roughness);
    coated.albedo = &*surface.albedo;
  }
  return coated;
}

/// The optics of the coat's upper boundary.
SurfaceOptics upper_side(const Incidence& in) {
  SurfaceOptics optics;
  optics.n_before = in.n_before;
  optics.n_after = in.n_layer;
  return optics;
}

} // namespace

void CoatedDiffuse::specular(const Incidence& in, const SpecularFactors& out) const {
  const SurfaceOptics optics = upper_side(in);
  for (int b = in.bands.first; b < in.bands.last; ++b)
    out.reflected[b] = static_cast<float>(optics.fractions(b, in.cos_o()).reflected);
}

double CoatedDiffuse::evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const {
  if (!(in.wo.z > 0.0)) return Diffuse().evaluate(in, wi, f_cos);
  const double pdf =
      evaluate_coated_ground(ground(*this, in), upper_side(in), in.wo, wi, in.live_bands(), f_cos);
  return roughness > 0.0 ? pdf : wi.z / std::numbers::pi; // a smooth coat's mirror is no part of it
}

std::optional<dvec3> CoatedDiffuse::sample(const Incidence& in, const dvec2& u,
                                           const dvec2& lobe) const {
  if (roughness > 0.0 && in.wo.z > 0.0)
    return sample_coated_ground(ground(*this, in), upper_side(in), in.wo, in.live_band(lobe.y), u,
                                lobe.x);
  return Diffuse().sample(in, u, lobe);
}

void CoatedDiffuse::find_albedo(double largest_ratio) {
  if (roughness > 0.0)
    albedo.emplace(Ggx::from_roughness(roughness), std::max(largest_ratio, 1.01));
}

} // namespace abbe
