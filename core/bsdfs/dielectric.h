#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/film_layer.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A smooth boundary between two clear media, bare or below a thin film. Transmitted radiance is
/// scaled by (n_before / n_after)^2, since a pencil of rays changes its solid angle there; flux is
/// not. Under total internal reflection nothing is transmitted.
struct Dielectric {
  BandTable reflectivity, transparency; ///< scale the two fractions that Fresnel's equations give
  bool fresnel = true; ///< without, the two are the fractions, and there is no film
  FilmLayer film;

  [[nodiscard]] BsdfFacts facts() const {
    return {.reflects = !reflectivity.zero(), .transmits = !transparency.zero()};
  }
  [[nodiscard]] BsdfLayer layer() const { return film.layer(); }
  void specular(const Incidence& in, const SpecularFactors& out) const;
  double evaluate(const Incidence& in, const dvec3&, float* f_cos) const {
    return evaluate_to_zero(in, f_cos);
  }
  [[nodiscard]] std::optional<dvec3> sample(const Incidence&, const dvec2&, const dvec2&) const {
    return std::nullopt;
  }
  /// The angle counts as that in the thinner medium, since total reflection would stop a straight
  /// ray where a refracted one gets through.
  void pass_straight(const Incidence& in, float* transmittance) const;
  /// The optics of one facet of such a boundary.
  [[nodiscard]] SurfaceOptics optics(const Incidence& in) const;
};

} // namespace abbe
