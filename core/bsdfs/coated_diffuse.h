#pragma once

#include "core/bsdfs/incidence.h"
#include "core/optics/albedo_table.h"

#include <optional>

namespace abbe {

/// Lambert's reflection below a clear coat, as of plastic or varnish. A smooth coat also reflects
/// like a mirror; a rough one reflects by its facets.
struct CoatedDiffuse {
  int coat = -1;                          ///< index into Plan::layers
  double roughness = 0.0;                 ///< of the coat, see Ggx::from_roughness; 0: smooth
  std::optional<DielectricAlbedo> albedo; ///< of the facets, if the integrator shows them

  [[nodiscard]] BsdfFacts facts() const {
    return {.reflects = true, .rough = roughness > 0.0, .coats = true};
  }
  [[nodiscard]] BsdfLayer layer() const { return {coat, false}; }
  void specular(const Incidence& in, const SpecularFactors& out) const;
  double evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample(const Incidence& in, const dvec2& u,
                                            const dvec2& lobe) const;
  /// Computes `albedo` for media and layers whose indices have at most this ratio.
  void find_albedo(double largest_ratio);
  void pass_straight(const Incidence& in, float* transmittance) const {
    block_straight(in, transmittance);
  }
};

} // namespace abbe
