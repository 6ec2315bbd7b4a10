#pragma once

#include "core/optics/transport.h"

namespace abbe {

/// A film on a boundary, at the bands.
struct FilmOptics {
  double thickness_nm = 0.0;         ///< 0: there is none
  const double* index = nullptr;     ///< per band, real
  const double* lambda_nm = nullptr; ///< per band, the wavelength at which `index` was taken
};

/// What a boundary returns and lets through, before a finish scales it.
struct Fractions {
  double reflected, transmitted;
};

/// The optics of a smooth boundary, or of one facet of a rough one, as arrays over bands: a
/// dielectric, or a metal where `metal_n` is given. Holds no memory of its own.
struct SurfaceOptics {
  const double* n_before = nullptr; ///< index on the side of `wo`
  const double* n_after = nullptr;  ///< index behind; not read where nothing goes through
  bool opaque = false;              ///< a metal, or a mirror that only reflects
  const float* metal_n = nullptr;   ///< complex index n - i k
  const float* metal_k = nullptr;
  FilmOptics film;
  bool fresnel = true; ///< without, all light is returned and all is let through but under TIR
  const float* reflectivity = nullptr; ///< scale the two fractions; null: 1 in all bands
  const float* transparency = nullptr;

  /// At the angle of incidence on the side of `wo`, before reflectivity and transparency.
  [[nodiscard]] Fractions fractions(int band, double cos_i) const;
  [[nodiscard]] double reflection_scale(int b) const { return reflectivity ? reflectivity[b] : 1; }
  [[nodiscard]] double transmission_scale(int b) const {
    return transparency ? transparency[b] : 1;
  }
  /// True where `fractions` of bands [first, last) are those of `first`, so that one evaluation
  /// serves all.
  [[nodiscard]] bool alike(int first, int last) const;
};

/// What a smooth boundary does to light at one angle: fills [first, last) of `reflected` and
/// `transmitted`, the latter with (n_before / n_after)^2 for radiance. The latter is null where it
/// is not asked for.
void scatter_smooth(const SurfaceOptics& optics, double cos_i, int first, int last,
                    Transport transport, float* reflected, float* transmitted);

/// The transmittance for the thesis's attenuated shadow ray, which goes straight on, multiplied
/// into [first, last); the angle is taken in the thinner medium.
void attenuate_straight(const SurfaceOptics& optics, double cos_i, int first, int last,
                        float* transmittance);

/// The bands of a bundle: [first, last) where `live` is not 0; all of them where it is null. Dead
/// bands carry no power and so take no part in random decisions.
struct BandSet {
  int first = 0, last = 0;
  const float* live = nullptr;
  [[nodiscard]] bool has(int b) const { return !live || live[b] != 0.0f; }
};

} // namespace abbe
