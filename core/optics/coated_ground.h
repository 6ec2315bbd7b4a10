#pragma once

#include "core/optics/albedo_table.h"
#include "core/optics/surface_optics.h"

#include <optional>

namespace abbe {

/// A clear coat on a Lambertian ground, as plastic or varnish: SurfaceOptics::n_after is the
/// coat's index, and no film lies on it. What the coat lets in is reflected between ground and
/// coat until it is absorbed or leaves. `optics.transparency` does not matter. Directions are in
/// the frame of the surface: +z is its normal on the side of `wo`, both point away from it.
struct CoatedGround {
  const float* ground = nullptr; ///< the ground's reflectance per band, 0..1
  std::optional<Ggx> rough;      ///< the coat's facets; nothing: it is smooth
  /// Of these facets; needed when they are there. Light that meets several of them is counted with
  /// what the coat lets in, so that none is lost.
  const DielectricAlbedo* albedo = nullptr;
};

/// What a smooth coat reflects like a mirror in a band, from a direction with cosine `mu`.
[[nodiscard]] double coat_reflectance(const SurfaceOptics& optics, double mu, int band);

/// The probability that a direction for `wo` is drawn by the coat's reflection and not by the
/// ground, for one band. Under a smooth coat the former is the mirror direction, and is not part of
/// what follows.
[[nodiscard]] double coat_chance(const CoatedGround& surface, const SurfaceOptics& optics,
                                 double mu, int band);

/// Fills f_cos[first, last) with the scattering function times cos of `wi`, symmetrical in `wo` and
/// `wi`, and returns the density per steradian of `wi`, a mean over live bands. With T(mu) = 1 -
/// what the coat reflects, its weighted mean T and eta = n_coat / n_before, the ground gives
///   rho T(wo) T(wi) / (pi eta^2 (1 - rho R)),   R = 1 - T / eta^2 the coat's from within:
/// at rho = 1 all that comes in goes out. A smooth coat's mirror reflection is left out.
double evaluate_coated_ground(const CoatedGround& surface, const SurfaceOptics& optics,
                              const dvec3& wo, const dvec3& wi, const BandSet& bands, float* f_cos);

/// A direction for `wo` by one band, from three numbers in [0, 1); the mirror direction exactly
/// where a smooth coat is chosen. Nothing where a facet would send it into the surface.
[[nodiscard]] std::optional<dvec3> sample_coated_ground(const CoatedGround& surface,
                                                        const SurfaceOptics& optics,
                                                        const dvec3& wo, int band, const dvec2& u,
                                                        double choice);

} // namespace abbe
