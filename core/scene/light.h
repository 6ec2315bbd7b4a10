#pragma once

#include "spectral/curve.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <numbers>
#include <string>
#include <variant>

namespace abbe {

using glm::dvec3;

/// `none`: the thesis's and Hill's lights; irradiance at normal incidence is pi times the value,
/// at any distance. `square`: the value is radiant intensity; irradiance falls with distance
/// squared.
enum class Falloff : std::uint8_t { none, square };

/// Light from one point to all sides.
struct PointLight {
  dvec3 position{0.0};
  Falloff falloff = Falloff::none;
};

/// Parallel light that travels along `direction` (unit).
struct DirectionalLight {
  dvec3 direction{0.0, 0.0, -1.0};
};

/// Light from one point into a cone. Full inside `full_angle` of the axis, none outside
/// `half_angle`, a smooth step between.
struct SpotLight {
  dvec3 position{0.0};
  dvec3 axis{0.0, 0.0, -1.0}; ///< unit
  double half_angle = 0.5;
  double full_angle = 0.5;
  Falloff falloff = Falloff::none;
};

/// A disc of directions from which parallel light comes. Irradiance is that of parallel light of
/// the same value; the radiance of the disc follows from it: pi value = radiance pi sin^2 radius.
struct SunLight {
  dvec3 direction{0.0, 0.0, -1.0}; ///< unit, along which its light travels
  double angular_radius = 0.2665 * std::numbers::pi / 180.0; ///< the sun's mean one [Cox00]
};

/// All kinds of light that a scene names. The functions that each kind has, and that a new one
/// needs, are listed in core/lights/light_kinds.h.
using LightKind = std::variant<PointLight, DirectionalLight, SpotLight, SunLight>;

/// A light of the scene that is no shape.
struct Light {
  std::string name;
  Curve spectrum = Curve::constant(1.0); ///< value per wavelength, intensity included
  LightKind kind;
};

} // namespace abbe
