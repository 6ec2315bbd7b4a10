#pragma once

#include "core/scene/light.h"

namespace abbe {

/// A lamp as seen from a point.
struct Illumination {
  dvec3 direction{0.0};  ///< unit, towards the lamp
  double distance = 0.0; ///< infinite for parallel light
  /// Irradiance on a surface that faces the lamp, over pi, per unit of the lamp's spectrum; times a
  /// diffuse reflectance and the cosine it is reflected radiance. 0 where the lamp does not shine.
  double strength = 0.0;
};

/// The part, 0 to 1, of a spotlight's full brightness that goes along a unit direction.
[[nodiscard]] double brightness_towards(const SpotLight& spot, const dvec3& direction);

/// As if from one direction: a sun counts as parallel light from the middle of its disc.
[[nodiscard]] Illumination illumination(const Light& light, const dvec3& point);

} // namespace abbe
