#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"

#include <optional>

namespace abbe {

/// A metal with GGX facets. Directions are in the frame of the surface, whose normal on the side of
/// `wo` is +z, and point away from it.
struct ConductorFacets {
  Ggx ggx;
  /// Adds the light that meets several facets [Kulla17]. Null: that light is lost.
  const GgxAlbedo* compensation = nullptr;
};

/// Fills f_cos[first, last) with the BSDF times |cos| of `wi` [Walter07, 20], and returns the pdf
/// per steradian with which `sample_conductor_facets` picks `wi`. Both are 0 below the surface. The
/// BSDF is symmetric in `wo` and `wi`.
double evaluate_conductor_facets(const ConductorFacets& surface, const SurfaceOptics& optics,
                                 const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                 float* f_cos);

/// Samples a direction, the same for all bands, with three numbers in [0, 1). Empty when the facet
/// would send the ray into the surface.
[[nodiscard]] std::optional<dvec3> sample_conductor_facets(const ConductorFacets& surface,
                                                           const dvec3& wo, const dvec2& u,
                                                           double choice);

} // namespace abbe
