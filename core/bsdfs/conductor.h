#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/film_layer.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A smooth metal with the complex index n - i k, bare or below a thin film.
struct Conductor {
  BandTable reflectivity; ///< scales what Fresnel's equations give
  BandTable n, k;
  FilmLayer film;

  [[nodiscard]] BsdfFacts facts() const { return {.reflects = true}; }
  [[nodiscard]] BsdfLayer layer() const { return film.layer(); }
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
  /// The optics of one facet of such a metal.
  [[nodiscard]] SurfaceOptics optics(const Incidence& in) const;
};

} // namespace abbe
