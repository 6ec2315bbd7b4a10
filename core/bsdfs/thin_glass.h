#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A pane of glass that is thin compared with everything else in the scene, with the same medium on
/// both sides. Light is reflected between its faces until it leaves or is absorbed. The pane is too
/// thick for visible interference. With r the reflectance of a face and a the part of the light
/// that one passage leaves, the pane reflects R and transmits T [BW99, 7.6]:
///   R = r + t^2 a^2 r / (1 - r^2 a^2),   T = t^2 a / (1 - r^2 a^2),   t = 1 - r,
/// for each polarisation; for unpolarised light they are the means of both. Transmitted light keeps
/// its direction.
struct ThinGlass {
  int glass = -1;                       ///< index into Plan::layers
  BandTable absorption;                 ///< a passage at normal incidence leaves exp(-absorption)
  BandTable reflectivity, transparency; ///< scale R and T

  [[nodiscard]] BsdfFacts facts() const {
    return {.reflects = !reflectivity.zero(), .passes = !transparency.zero()};
  }
  [[nodiscard]] BsdfLayer layer() const { return {glass, false}; }
  void specular(const Incidence& in, const SpecularFactors& out) const;
  double evaluate(const Incidence& in, const dvec3&, float* f_cos) const {
    return evaluate_to_zero(in, f_cos);
  }
  [[nodiscard]] std::optional<dvec3> sample(const Incidence&, const dvec2&, const dvec2&) const {
    return std::nullopt;
  }
  void pass_straight(const Incidence& in, float* transmittance) const;
};

} // namespace abbe
