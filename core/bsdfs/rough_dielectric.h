#pragma once

#include "core/bsdfs/dielectric.h"
#include "core/optics/albedo_table.h"

#include <optional>

namespace abbe {

/// A boundary between two clear media with GGX facets.
struct RoughDielectric {
  Dielectric facet;
  double roughness = 0.0;                 ///< see Ggx::from_roughness
  bool compensation = true;               ///< adds the light that meets several facets
  std::optional<DielectricAlbedo> albedo; ///< for the compensation

  [[nodiscard]] BsdfFacts facts() const;
  [[nodiscard]] BsdfLayer layer() const { return facet.layer(); }
  void specular(const Incidence& in, const SpecularFactors& out) const { facet.specular(in, out); }
  double evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample(const Incidence& in, const dvec2& u,
                                            const dvec2& lobe) const;
  /// Computes `albedo` for media and layers whose indices have at most this ratio.
  void find_albedo(double largest_ratio);
  void pass_straight(const Incidence& in, float* transmittance) const {
    facet.pass_straight(in, transmittance);
  }
};

} // namespace abbe
