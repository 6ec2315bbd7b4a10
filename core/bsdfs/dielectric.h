#pragma once

#include "core/bands/band_table.h"
#include "core/bsdfs/film_layer.h"
#include "core/bsdfs/incidence.h"

#include <optional>

namespace abbe {

/// A smooth boundary between two clear media, bare or below a thin film. Radiance that comes
/// through is scaled by (n_before / n_after)^2, since a pencil of rays changes its solid angle
/// there; flux is not. Under total internal reflection nothing comes through.
struct Dielectric {
  BandTable reflectivity, transparency; ///< scale the two fractions that Fresnel's equations give
  bool fresnel = true; ///< without, the two are the fractions; there is no film then
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
  /// The angle is taken in the thinner medium, so that total reflection, which a bent ray would
  /// have avoided, does not occur.
  void pass_straight(const Incidence& in, float* transmittance) const;
  /// As the optics of one facet.
  [[nodiscard]] SurfaceOptics optics(const Incidence& in) const;
};

} // namespace abbe
