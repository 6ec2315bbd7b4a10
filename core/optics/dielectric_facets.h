#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"
#include "core/optics/transport.h"

#include <optional>

namespace abbe {

/// A boundary between clear media with GGX facets. Directions are in the frame of the surface: +z
/// is its normal on the side of `wo`, both point away from it, and wi.z < 0 is transmission.
struct DielectricFacets {
  Ggx ggx;
  /// Adds what meets several facets, for clear facets without a film [Kulla17]; null: it is lost.
  const DielectricAlbedo* compensation = nullptr;
  Transport transport = Transport::radiance; ///< what is scattered
};

/// Fills f_cos[first, last) with the scattering function times |cos| of `wi`, each band by its own
/// half vector [Walter07, 20 and 21], and returns the density per steradian with which
/// `sample_dielectric_facets` picks `wi` for a live band chosen at random: the mean of their
/// densities. Where the optics are alike in all bands, this is one evaluation.
/// With n_o and n_i the indices on the sides of `wo` and `wi`, f / n_i^2 for flux and f / n_o^2 for
/// radiance stay as they are when the two directions and their media are exchanged.
double evaluate_dielectric_facets(const DielectricFacets& surface, const SurfaceOptics& optics,
                                  const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                  float* f_cos);

/// A direction for `wo` by the optics of one band, from three numbers in [0, 1). Nothing where the
/// facet would send it to the wrong side.
[[nodiscard]] std::optional<dvec3> sample_dielectric_facets(const DielectricFacets& surface,
                                                            const SurfaceOptics& optics,
                                                            const dvec3& wo, int band,
                                                            const dvec2& u, double choice);

} // namespace abbe
