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

/// A bundle of bands that meets a surface, as a BSDF sees it. Arrays are over bands, padded like
/// those of BandTable; of each only `bands` are meant, as they are of the rows that a BSDF fills.
/// Directions are in the frame of the surface: +z is its normal on the side that the ray comes
/// from, and both point away from it.
struct Incidence {
  BandRange bands;
  const double* n_before = nullptr;  ///< index of the medium on the side of `wo`
  const double* n_after = nullptr;   ///< index of the medium behind the surface
  const double* n_layer = nullptr;   ///< index of the BSDF's layer, if it has one
  const double* lambda_nm = nullptr; ///< wavelengths of these indices, for interference
  const float* live = nullptr;       ///< throughput; bands where it is 0 take no part in sampling
  const float* ground = nullptr;     ///< the diffuse reflectance
  Transport transport = Transport::radiance;
  dvec3 wo{0.0, 0.0, 1.0}; ///< unit, towards the origin of the ray

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

/// Factors per band on the light of the reflected ray, and on that of the refracted or the straight
/// ray. A BSDF fills those arrays for which its facts say that there is such light.
struct SpecularFactors {
  float* reflected = nullptr;
  float* transmitted = nullptr;
};

/// The layer of a BSDF: a film, a coat, or the glass of a pane.
struct BsdfLayer {
  int index = -1;          ///< into Plan::layers; negative: there is none
  bool interferes = false; ///< it needs the wavelengths
};

/// Where light goes that meets a BSDF, for the plan and the integrators.
struct BsdfFacts {
  bool reflects = false;  ///< some is reflected, by the surface or by its facets
  bool transmits = false; ///< some is refracted, by the surface or by its facets
  bool passes = false;    ///< some goes straight on, which does not count as a bounce
  bool rough = false;     ///< facets scatter it in many directions
  bool coats = false;     ///< the BSDF includes the material's diffuse part

  /// True when light goes on other than by Lambert's part.
  [[nodiscard]] bool goes_on() const { return reflects || transmits || passes; }
  /// True when light goes on along single rays: reflected, refracted or straight on.
  [[nodiscard]] bool specular() const { return !rough && goes_on(); }
  friend bool operator==(const BsdfFacts&, const BsdfFacts&) = default;
};

/// The facts of a mixture, of which a ray meets one or the other part. They do not say `rough`:
/// light may go along single rays, whatever the parts are.
[[nodiscard]] inline BsdfFacts either(const BsdfFacts& a, const BsdfFacts& b) {
  return {a.reflects || b.reflects, a.transmits || b.transmits, a.passes || b.passes, false, false};
}

/// Evaluates a BSDF that has only specular parts: it is 0, and so is the pdf.
inline double evaluate_to_zero(const Incidence& in, float* f_cos) {
  std::fill(f_cos + in.bands.first, f_cos + in.bands.last, 0.0f);
  return 0.0;
}

/// Makes the transmittance 0, as an opaque surface does.
inline void block_straight(const Incidence& in, float* transmittance) {
  std::fill(transmittance + in.bands.first, transmittance + in.bands.last, 0.0f);
}

} // namespace abbe
