#pragma once

#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"

namespace abbe {

/// The optics of a smooth boundary, or of one facet of a rough one, as arrays over bands: a
/// dielectric, or a metal where `metal_n` is given. Holds no memory of its own.
struct SurfaceOptics {
  const double* n_before = nullptr; ///< index on the side of `wo`
  const double* n_after = nullptr;  ///< index behind; not read where nothing goes through
  bool opaque = false;              ///< a metal, or a mirror that only reflects
  const float* metal_n = nullptr;   ///< complex index n - i k
  const float* metal_k = nullptr;
  FilmOptics film;
  bool fresnel = true;                 ///< without, all is returned, see dielectric_fractions
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

/// The bands of a bundle: [first, last) where `live` is not 0; all of them where it is null. Dead
/// bands carry no power and so take no part in random decisions.
struct BandSet {
  int first = 0, last = 0;
  const float* live = nullptr;
  [[nodiscard]] bool has(int b) const { return !live || live[b] != 0.0f; }
};

} // namespace abbe
