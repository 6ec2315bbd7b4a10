#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A pane of glass that is thin beside all else in the scene, with the same medium on both sides.
/// Light is reflected between its faces until it has left or is absorbed, too often for
/// interference to show. With r the reflectance of a face and a the part of the light that one
/// passage leaves, the pane returns and lets through [BW99, 7.6]
///   R = r + t^2 a^2 r / (1 - r^2 a^2),   T = t^2 a / (1 - r^2 a^2),   t = 1 - r,
/// for each polarisation; for unpolarised light these are the means of both. What comes through
/// keeps its direction.
struct ThinGlass {
  int glass = -1;       ///< its index, into Plan::layers
  BandTable absorption; ///< of a passage straight through: that leaves exp(-absorption)
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
