#pragma once

#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// Lambert's reflection alone: it neither reflects like a mirror nor transmits. Its reflectance is
/// Incidence::ground, which may come from a texture. `wi` must lie above the surface.
struct Diffuse {
  [[nodiscard]] BsdfFacts facts() const { return {}; }
  [[nodiscard]] BsdfLayer layer() const { return {}; }
  void specular(const Incidence&, const SpecularFactors&) const {}
  double evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const;
  [[nodiscard]] std::optional<dvec3> sample(const Incidence& in, const dvec2& u,
                                            const dvec2& lobe) const;
  void pass_straight(const Incidence& in, float* transmittance) const {
    block_straight(in, transmittance);
  }
};

} // namespace abbe
