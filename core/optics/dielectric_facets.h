#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"
#include "core/optics/transport.h"

#include <optional>

namespace abbe {

/// A boundary between clear media with GGX facets. Directions are in the frame of the surface,
/// whose normal on the side of `wo` is +z, and point away from it; wi.z < 0 is transmission.
struct DielectricFacets {
  Ggx ggx;
  /// Adds the light that meets several facets, for clear facets without a film [Kulla17]. Null:
  /// that light is lost.
  const DielectricAlbedo* compensation = nullptr;
  Transport transport = Transport::radiance; ///< what is scattered
};

/// Fills f_cos[first, last) with the BSDF times |cos| of `wi`, each band by its own half vector
/// [Walter07, 20 and 21], and returns the pdf per steradian with which `sample_dielectric_facets`
/// picks `wi` for a live band chosen at random, which is the mean of the bands' pdfs. One
/// evaluation serves all bands whose optics are alike. With n_o and n_i the indices on the sides of
/// `wo` and `wi`, f / n_i^2 for flux and f / n_o^2 for radiance do not change when the two
/// directions and their media are exchanged.
double evaluate_dielectric_facets(const DielectricFacets& surface, const SurfaceOptics& optics,
                                  const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                  float* f_cos);

/// Samples a direction by the optics of one band with three numbers in [0, 1). Empty when the facet
/// would send the ray to the wrong side.
[[nodiscard]] std::optional<dvec3> sample_dielectric_facets(const DielectricFacets& surface,
                                                            const SurfaceOptics& optics,
                                                            const dvec3& wo, int band,
                                                            const dvec2& u, double choice);

} // namespace abbe
