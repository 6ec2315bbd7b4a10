#pragma once

#include "core/bsdfs/coated_diffuse.h"
#include "core/bsdfs/conductor.h"
#include "core/bsdfs/dielectric.h"
#include "core/bsdfs/diffuse.h"
#include "core/bsdfs/mirror.h"
#include "core/bsdfs/rough_conductor.h"
#include "core/bsdfs/rough_dielectric.h"
#include "core/bsdfs/thin_glass.h"

#include <variant>

namespace abbe {

/// The closed set of BSDFs. A material adds one of them to the thesis's sum of Lambert's part and
/// Phong's highlight. Every type of the set has these members, which the functions below visit:
///
///   facts()                 where light goes, for the plan and the integrators
///   layer()                 its layer, if it has one
///   specular(in, factors)   fills the factors per band on the reflected and the refracted ray; a
///                           rough surface gives those of a smooth one
///   evaluate(in, wi, f_cos) fills in the non-specular part of the BSDF times cosine, per band, and
///                           returns the pdf with which `sample` picks `wi`
///   sample(in, u, lobe)     a direction for four numbers in [0, 1), of which lobe.x chooses the
///                           lobe and lobe.y the band by which it scatters; empty where the
///                           direction brings no light
///   pass_straight(in, t)    multiplies `t` by the transmittance for the thesis's attenuated shadow
///                           ray, which goes straight on
///
/// A new BSDF needs a file pair with such a type, its name here, a test, and a keyword that makes
/// it. See docs/decisions/bsdfs.md.
using Bsdf = std::variant<Diffuse, CoatedDiffuse, Mirror, Conductor, Dielectric, RoughConductor,
                          RoughDielectric, ThinGlass>;

[[nodiscard]] inline BsdfFacts facts_of(const Bsdf& bsdf) {
  return std::visit([](const auto& b) { return b.facts(); }, bsdf);
}
[[nodiscard]] inline BsdfLayer layer_of(const Bsdf& bsdf) {
  return std::visit([](const auto& b) { return b.layer(); }, bsdf);
}
inline void specular_factors(const Bsdf& bsdf, const Incidence& in, const SpecularFactors& out) {
  std::visit([&](const auto& b) { b.specular(in, out); }, bsdf);
}
inline double evaluate(const Bsdf& bsdf, const Incidence& in, const dvec3& wi, float* f_cos) {
  return std::visit([&](const auto& b) { return b.evaluate(in, wi, f_cos); }, bsdf);
}
[[nodiscard]] inline std::optional<dvec3> sample(const Bsdf& bsdf, const Incidence& in,
                                                 const dvec2& u, const dvec2& lobe) {
  return std::visit([&](const auto& b) { return b.sample(in, u, lobe); }, bsdf);
}
inline void pass_straight(const Bsdf& bsdf, const Incidence& in, float* transmittance) {
  std::visit([&](const auto& b) { b.pass_straight(in, transmittance); }, bsdf);
}

} // namespace abbe
