#pragma once

#include "core/bands/band_range.h"
#include "core/optics/surface_optics.h"
#include "core/optics/transport.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace abbe {

using glm::dvec2;
using glm::dvec3;

/// A bundle of bands that meets a surface, as a BSDF sees it. Arrays are over bands; of each only
/// `bands` are meant, as they are of the rows that a BSDF fills. Directions are in the frame of the
/// surface: +z is its normal on the side that the ray comes from, and both point away from it.
struct Incidence {
  BandRange bands;
  const double* n_before = nullptr;  ///< index of the medium on the side of `wo`
  const double* n_after = nullptr;   ///< index of the medium behind the surface
  const double* n_layer = nullptr;   ///< index of the BSDF's own layer, if it has one
  const double* lambda_nm = nullptr; ///< wavelengths of these indices, where interference asks
  const float* live = nullptr;       ///< throughput; bands where it is 0 take no part in sampling
  const float* ground = nullptr;     ///< the diffuse reflectance of what lies below
  Transport transport = Transport::radiance;
  dvec3 wo{0.0, 0.0, 1.0}; ///< where the ray came from

  [[nodiscard]] double cos_o() const { return std::min(1.0, std::abs(wo.z)); }
  [[nodiscard]] BandSet live_bands() const { return {bands.first, bands.last, live}; }
  /// One of the bands that carry light, by a number in [0, 1).
  [[nodiscard]] int live_band(double choice) const {
    int count = 0;
    for (int b = bands.first; b < bands.last; ++b)
      count += live[b] != 0.0f;
    int left = static_cast<int>(choice * count);
    for (int b = bands.first; b < bands.last; ++b)
      if (live[b] != 0.0f && left-- == 0) return b;
    return bands.first;
  }
};

/// Rows of factors on what comes along the one reflected ray and along the refracted rays, or
/// straight through. A BSDF fills those for which its facts say that there is such light.
struct SpecularFactors {
  float* reflected = nullptr;
  float* transmitted = nullptr;
};

/// The layer of its own that a BSDF has: a film, a coat, the glass of a pane.
struct BsdfLayer {
  int index = -1;          ///< into Plan::layers; negative: it has none
  bool interferes = false; ///< the wavelengths are needed too
};

/// Where the light goes that meets a BSDF, for the plan and for those who follow paths.
struct BsdfFacts {
  bool reflects = false;  ///< some is mirrored, by the surface or by its facets
  bool transmits = false; ///< some is refracted, by the surface or by its facets
  bool passes = false;    ///< some goes straight on, and that is no event of the path
  bool rough = false;     ///< by facets in many directions, and not along single rays
  bool coats = false;     ///< the BSDF takes the diffuse part of the material into itself

  /// True when some light goes on, other than by Lambert's part.
  [[nodiscard]] bool goes_on() const { return reflects || transmits || passes; }
  /// True when some light goes on along single rays: reflected, refracted or straight through.
  [[nodiscard]] bool specular() const { return !rough && goes_on(); }
  friend bool operator==(const BsdfFacts&, const BsdfFacts&) = default;
};

/// Where the light of two goes, of which a ray meets one or the other. Along single rays it may go
/// whatever they are.
[[nodiscard]] inline BsdfFacts either(const BsdfFacts& a, const BsdfFacts& b) {
  return {a.reflects || b.reflects, a.transmits || b.transmits, a.passes || b.passes, false, false};
}

/// What a BSDF without a part that scatters in many directions evaluates to; the pdf is 0 too.
inline double evaluate_to_zero(const Incidence& in, float* f_cos) {
  std::fill(f_cos + in.bands.first, f_cos + in.bands.last, 0.0f);
  return 0.0;
}

/// What an opaque surface leaves of a straight shadow ray.
inline void block_straight(const Incidence& in, float* transmittance) {
  std::fill(transmittance + in.bands.first, transmittance + in.bands.last, 0.0f);
}

} // namespace abbe
