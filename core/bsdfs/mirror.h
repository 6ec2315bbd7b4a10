#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A mirror that reflects the same part of the light at every angle.
struct Mirror {
  BandTable reflectivity;

  [[nodiscard]] BsdfFacts facts() const { return {.reflects = true}; }
  [[nodiscard]] BsdfLayer layer() const { return {}; }
  void specular(const Incidence& in, const SpecularFactors& out) const;
  double evaluate(const Incidence& in, const dvec3&, float* f_cos) const {
    return evaluate_to_zero(in, f_cos);
  }
  [[nodiscard]] std::optional<dvec3> sample(const Incidence&, const dvec2&, const dvec2&) const {
    return std::nullopt;
  }
  void pass_straight(const Incidence& in, float* transmittance) const {
    block_straight(in, transmittance);
  }
  /// The optics of one facet of such a mirror.
  [[nodiscard]] SurfaceOptics optics(const Incidence& in) const;
};

} // namespace abbe
