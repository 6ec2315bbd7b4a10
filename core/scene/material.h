#pragma once

#include "core/scene/drops.h"
#include "core/scene/texture.h"
#include "geometry/rays/ids.h"
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
  friend bool operator==(const Medium&, const Medium&) = default;
};

/// A metal's complex refractive index n - i k.
struct ConductorIndex {
  Curve n, k;
  friend bool operator==(const ConductorIndex&, const ConductorIndex&) = default;
};

/// Two materials in one surface, too fine to be seen apart: at each place a ray meets the first
/// with the chance `share`, else the second. Both stand before the mixture in Scene::materials.
struct Mixture {
  MaterialId first, second;
  double share = 0.5;
  friend bool operator==(const Mixture&, const Mixture&) = default;
};

/// A clear film on a boundary, thin enough for colours of interference.
struct ThinFilm {
  double thickness_nm = 0.0;
  Dispersion index = ConstantIndex{1.0};
  friend bool operator==(const ThinFilm&, const ThinFilm&) = default;
};

/// A pane of glass, thin beside all else in the scene. With the material's other parts come what
/// reflectivity and transparency leave of what it reflects and lets through.
struct ThinPane {
  double thickness_mm = 0.0;
  Dispersion index = ConstantIndex{1.0};
  Curve absorption_per_mm = Curve::constant(0.0);
  friend bool operator==(const ThinPane&, const ThinPane&) = default;
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
  std::optional<Texture> texture;      ///< in place of `diffuse`
  std::optional<Mixture> mixture;      ///< in place of everything else
  /// From 0, smooth, to 1: the width of the facets' slopes is its square, see Ggx.
  double roughness = 0.0;
  bool compensation = true;       ///< of a rough surface: light that meets several facets is kept
  std::optional<ThinFilm> film;   ///< on glass or metal
  std::optional<Dispersion> coat; ///< a clear coat of this index on the diffuse part
  std::optional<ThinPane> pane;   ///< a flat shape is a pane of glass, which bends no light
  friend bool operator==(const Material&, const Material&) = default;
};

} // namespace abbe
