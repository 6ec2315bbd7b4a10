#pragma once

#include "spectral/curve.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <numbers>
#include <string>
#include <variant>

namespace abbe {

using glm::dvec3;

/// How irradiance depends on the distance from a light. `none`, as in the thesis and in Hill's
/// renderer: at normal incidence it is pi times the light's value at any distance. `square`: the
/// value is a radiant intensity, and irradiance falls with the square of the distance.
enum class Falloff : std::uint8_t { none, square };

/// A light that shines from one point in all directions.
struct PointLight {
  dvec3 position{0.0};
  Falloff falloff = Falloff::none;
};

/// Parallel light.
struct DirectionalLight {
  dvec3 direction{0.0, 0.0, -1.0}; ///< unit, along which the light travels
};

/// A light that shines from one point into a cone: with full strength within `full_angle` of the
/// axis, not at all beyond `half_angle`, and with a smooth step between.
struct SpotLight {
  dvec3 position{0.0};
  dvec3 axis{0.0, 0.0, -1.0}; ///< unit
  double half_angle = 0.5;
  double full_angle = 0.5;
  Falloff falloff = Falloff::none;
};

/// A disc in the sky. At normal incidence its irradiance is pi times the light's value, as that of
/// parallel light is. The radiance of the disc follows: pi value = radiance pi sin^2 radius.
struct SunLight {
  dvec3 direction{0.0, 0.0, -1.0}; ///< unit, along which the light from its middle travels
  double angular_radius = 0.2665 * std::numbers::pi / 180.0; ///< by default the sun's mean [Cox00]
};

/// All kinds of lights that are no shapes. core/lights/light_kinds.h lists the functions that each
/// kind has and that a new one needs.
using LightKind = std::variant<PointLight, DirectionalLight, SpotLight, SunLight>;

/// A light that is no shape.
struct Light {
  std::string name;
  Curve spectrum = Curve::constant(1.0); ///< the value by wavelength, times the intensity
  LightKind kind;
  std::string group = {}; ///< of which it is a part; empty: of that of its name
};

} // namespace abbe
