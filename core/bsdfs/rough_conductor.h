#pragma once

#include "core/bsdfs/conductor.h"
#include "core/bsdfs/mirror.h"
#include "core/optics/albedo_table.h"

#include <optional>
#include <variant>

namespace abbe {

/// A metal or a mirror with GGX facets.
struct RoughConductor {
  std::variant<Mirror, Conductor> facet;
  double roughness = 0.0;          ///< see Ggx::from_roughness
  bool compensation = true;        ///< adds the light that meets several facets
  std::optional<GgxAlbedo> albedo; ///< for the compensation

  [[nodiscard]] BsdfFacts facts() const { return {.reflects = true, .rough = true}; }
  [[nodiscard]] BsdfLayer layer() const;
  void specular(const Incidence& in, const SpecularFactors& out) const;
  double evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample(const Incidence& in, const dvec2& u,
                                            const dvec2& lobe) const;
  /// Computes `albedo`, which does not depend on the media.
  void find_albedo(double largest_ratio);
  void pass_straight(const Incidence& in, float* transmittance) const {
    block_straight(in, transmittance);
  }
};

} // namespace abbe
