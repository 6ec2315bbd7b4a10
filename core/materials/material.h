#pragma once

#include "core/media/drops.h"
#include "spectral/curve.h"
#include "spectral/dispersion.h"

#include <optional>
#include <string>

namespace abbe {

/// What fills a solid.
struct Medium {
  std::string name;
  Dispersion index = ConstantIndex{1.0};
  Curve absorption_per_mm = Curve::constant(0.0); ///< Beer-Lambert: exp(-absorption * length)
  std::optional<Drops> drops{};                   ///< that hang in it; its index is then 1
};

/// A metal's complex refractive index n - i k.
struct ConductorIndex {
  Curve n, k;
  friend bool operator==(const ConductorIndex&, const ConductorIndex&) = default;
};

/// The finish of a surface, as the thesis has it: a sum of parts, each a curve of factors from 0
/// to 1 (the part's amount times the material's colour). A part that is 0 everywhere is absent.
struct Material {
  std::string name;
  Curve ambient = Curve::constant(0.0);
  Curve diffuse = Curve::constant(0.0);
  Curve specular = Curve::constant(0.0);
  Curve emission = Curve::constant(0.0); ///< radiance that the surface gives off
  bool emits_behind = true; ///< a flat shape gives it off on both sides; a solid does so outwards
  double specular_exponent = 1.0;
  Curve reflectivity = Curve::constant(0.0); ///< scales the reflected part
  Curve transparency = Curve::constant(0.0); ///< scales the refracted part
  /// With Fresnel the two scale the fractions that Fresnel's equations give; without, they are
  /// the fractions.
  bool fresnel = true;
  std::optional<ConductorIndex> metal; ///< Fresnel's fraction is then the metal's
};

} // namespace abbe
