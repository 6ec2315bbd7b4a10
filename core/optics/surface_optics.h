#pragma once

#include "core/optics/fresnel.h"
#include "core/optics/thin_film.h"

namespace abbe {

/// The optics of a smooth boundary, or of one facet of a rough one, as arrays over bands: a
/// dielectric, or a metal where `metal_n` is given. The arrays belong to others.
struct SurfaceOptics {
  const double* n_before = nullptr; ///< index on the side of `wo`
  const double* n_after = nullptr;  ///< index behind; not used where nothing is transmitted
  bool opaque = false;              ///< a metal or a mirror
  const float* metal_n = nullptr;   ///< complex index n - i k
  const float* metal_k = nullptr;
  FilmOptics film;
  bool fresnel = true;                 ///< see dielectric_fractions
  const float* reflectivity = nullptr; ///< both scale the fractions; null: 1
  const float* transparency = nullptr;

  /// The fractions before reflectivity and transparency; `cos_i` is on the side of `wo`.
  [[nodiscard]] Fractions fractions(int band, double cos_i) const;
  [[nodiscard]] double reflection_scale(int b) const { return reflectivity ? reflectivity[b] : 1; }
  [[nodiscard]] double transmission_scale(int b) const {
    return transparency ? transparency[b] : 1;
  }
  /// True when the fractions of all bands [first, last) are those of `first`, so that one
  /// evaluation serves all.
  [[nodiscard]] bool alike(int first, int last) const;
};

/// The bands [first, last) of a bundle whose `live` is not 0, or all of them if `live` is null. The
/// others carry no power and therefore take no part in random decisions.
struct BandSet {
  int first = 0, last = 0;
  const float* live = nullptr;
  [[nodiscard]] bool has(int b) const { return !live || live[b] != 0.0f; }
};

} // namespace abbe
