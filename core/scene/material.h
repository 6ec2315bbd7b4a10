#pragma once

#include "core/scene/drops.h"
#include "core/scene/texture.h"
#include "geometry/rays/ids.h"
#include "spectral/curve.h"
#include "spectral/dispersion.h"

#include <optional>
#include <string>

namespace abbe {

/// The medium that fills a solid.
struct Medium {
  std::string name;
  Dispersion index = ConstantIndex{1.0};
  Curve absorption_per_mm = Curve::constant(0.0); ///< Beer-Lambert: exp(-absorption * length)
  std::optional<Drops> drops{};                   ///< drops that hang in it; its index is then 1
  friend bool operator==(const Medium&, const Medium&) = default;
};

/// A metal's complex refractive index n - i k.
struct ConductorIndex {
  Curve n, k;
  friend bool operator==(const ConductorIndex&, const ConductorIndex&) = default;
};

/// Two materials in one surface, mixed too finely to be seen apart. A ray meets the first with the
/// probability `share`, else the second. Both precede the mixture in Scene::materials.
struct Mixture {
  MaterialId first, second;
  double share = 0.5;
  friend bool operator==(const Mixture&, const Mixture&) = default;
};

/// A clear film on a boundary, so thin that interference colours it.
struct ThinFilm {
  double thickness_nm = 0.0;
  Dispersion index = ConstantIndex{1.0};
  friend bool operator==(const ThinFilm&, const ThinFilm&) = default;
};

/// A pane of glass, thin compared with everything else in the scene. The material's reflectivity
/// and transparency scale what the pane reflects and what it lets through.
struct ThinPane {
  double thickness_mm = 0.0;
  Dispersion index = ConstantIndex{1.0};
  Curve absorption_per_mm = Curve::constant(0.0);
  friend bool operator==(const ThinPane&, const ThinPane&) = default;
};

/// The thesis's model of a surface: a sum of parts. Each part is a curve of factors from 0 to 1
/// (its amount times the material's colour), and a part that is 0 everywhere is absent.
struct Material {
  std::string name;
  Curve ambient = Curve::constant(0.0);
  Curve diffuse = Curve::constant(0.0);
  Curve specular = Curve::constant(0.0);
  Curve emission = Curve::constant(0.0); ///< the radiance that the surface emits
  bool emits_behind = true; ///< a flat shape emits on both sides; a solid always outwards
  double specular_exponent = 1.0;
  Curve reflectivity = Curve::constant(0.0); ///< scales the reflected part
  Curve transparency = Curve::constant(0.0); ///< scales the refracted part
  /// With `fresnel` the two scale the fractions that Fresnel's equations give; without, they are
  /// themselves the fractions.
  bool fresnel = true;
  std::optional<ConductorIndex> metal; ///< Fresnel's equations are then those of the metal
  std::optional<Texture> texture;      ///< in place of `diffuse`
  std::optional<Mixture> mixture;      ///< in place of everything else
  /// From 0 (smooth) to 1. The width of the facets' slopes is its square; see Ggx::from_roughness.
  double roughness = 0.0;
  bool compensation = true;       ///< adds the light that meets several facets of a rough surface
  std::optional<ThinFilm> film;   ///< on glass or metal
  std::optional<Dispersion> coat; ///< the index of a clear coat on the diffuse part
  std::optional<ThinPane> pane;   ///< makes a flat shape a pane, which bends no light
  friend bool operator==(const Material&, const Material&) = default;
};

} // namespace abbe
