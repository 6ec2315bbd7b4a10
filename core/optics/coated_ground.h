#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"

#include <optional>

namespace abbe {

/// A clear coat on a Lambertian ground, such as plastic or varnish. SurfaceOptics::n_after is the
/// coat's index, there is no film, and SurfaceOptics::transparency is not used. Light that the coat
/// lets in is reflected between ground and coat until it is absorbed or leaves. Directions are in
/// the frame of the surface, whose normal on the side of `wo` is +z, and point away from it.
struct CoatedGround {
  const float* ground = nullptr; ///< the ground's reflectance per band, 0..1
  std::optional<Ggx> rough;      ///< the coat's facets; empty: it is smooth
  /// The albedo of these facets, not null where there are any. Light that meets several of them is
  /// counted with what the coat lets in, so that none is lost.
  const DielectricAlbedo* albedo = nullptr;
};

/// The part of the light of a band that a smooth coat reflects like a mirror, for a direction with
/// cosine `mu`.
[[nodiscard]] double coat_reflectance(const SurfaceOptics& optics, double mu, int band);

/// The probability that `sample_coated_ground` chooses the coat's reflection and not the ground,
/// for one band and a `wo` with cosine `mu`. With a smooth coat that reflection is the mirror
/// direction, and `evaluate_coated_ground` leaves it out.
[[nodiscard]] double coat_chance(const CoatedGround& surface, const SurfaceOptics& optics,
                                 double mu, int band);

/// Fills f_cos[first, last) with the BSDF, which is symmetric in `wo` and `wi`, times the cosine of
/// `wi`, and returns the mean over live bands of the pdf of `wi` per steradian. With T(mu) = 1 -
/// what the coat reflects, its cosine-weighted mean T and eta = n_coat / n_before, the ground gives
///   rho T(wo) T(wi) / (pi eta^2 (1 - rho R)),   R = 1 - T / eta^2,
/// where R is the coat's reflectance from within. At rho = 1 all light that comes in goes out. The
/// mirror reflection of a smooth coat is left out.
double evaluate_coated_ground(const CoatedGround& surface, const SurfaceOptics& optics,
                              const dvec3& wo, const dvec3& wi, const BandSet& bands, float* f_cos);

/// Samples a direction by the optics of one band with three numbers in [0, 1). Where it chooses a
/// smooth coat, the result is exactly the mirror direction. Empty when a facet would send the ray
/// into the surface.
[[nodiscard]] std::optional<dvec3> sample_coated_ground(const CoatedGround& surface,
                                                        const SurfaceOptics& optics,
                                                        const dvec3& wo, int band, const dvec2& u,
                                                        double choice);

} // namespace abbe
