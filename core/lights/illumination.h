#pragma once

#include "core/scene/light.h"

namespace abbe {

/// A light as seen from a point, as if from one direction: a sun counts as parallel light from the
/// middle of its disc.
struct Illumination {
  dvec3 direction{0.0};  ///< unit, towards the light
  double distance = 0.0; ///< infinite for parallel light
  /// Irradiance on a surface that faces the light, over pi, per unit of the light's spectrum; times
  /// a diffuse reflectance and the cosine it is reflected radiance. 0 where the light does not
  /// shine.
  double strength = 0.0;
};

/// The illumination of a point by a light that stands at a position and shines to all sides.
[[nodiscard]] Illumination illumination_from(const dvec3& position, Falloff falloff,
                                             const dvec3& point);

/// The illumination by full parallel light that travels along a unit direction.
[[nodiscard]] Illumination illumination_along(const dvec3& direction);

/// How bright a light of this value at a position counts, which may be seen from as near as
/// `nearest`; see brightest in light_kinds.h.
[[nodiscard]] double brightest_from(Falloff falloff, double value, double nearest);

} // namespace abbe
