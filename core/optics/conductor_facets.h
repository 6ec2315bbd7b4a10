#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"

#include <optional>

namespace abbe {

/// A metal with GGX facets. Directions are in the frame of the surface: +z is its normal on the
/// side of `wo`, both point away from it.
struct ConductorFacets {
  Ggx ggx;
  /// Adds what meets several facets [Kulla17]; null: it is lost.
  const GgxAlbedo* compensation = nullptr;
};

/// Fills f_cos[first, last) with the scattering function times |cos| of `wi` [Walter07, 20], and
/// returns the density per steradian with which `sample_conductor_facets` picks `wi`. Both are 0
/// below the surface. Exchanging `wo` and `wi` leaves the function as it is.
double evaluate_conductor_facets(const ConductorFacets& surface, const SurfaceOptics& optics,
                                 const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                 float* f_cos);

/// A direction for `wo`, from three numbers in [0, 1); the same for all bands. Nothing where the
/// facet would send it into the surface.
[[nodiscard]] std::optional<dvec3> sample_conductor_facets(const ConductorFacets& surface,
                                                           const dvec3& wo, const dvec2& u,
                                                           double choice);

} // namespace abbe
