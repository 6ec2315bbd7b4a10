#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace abbe::stress {

/// One statement that moves what follows it. `values` are those of the scene language: x y z, or
/// the angle in degrees and the axis.
struct Placing {
  enum class Kind : std::uint8_t { translate, rotate, scale };
  Kind kind;
  std::array<double, 4> values;
};

/// A solid or a flat shape with the statements that place it, outermost first. The numbers are the
/// arguments of its keyword; a boolean has two operands.
struct Solid {
  enum class Kind : std::uint8_t {
    sphere,
    cube,
    prism,
    cylinder,
    cone,
    tapered_cylinder,
    planes,
    lens_element,
    cemented,
    mesh,
    set_union,
    intersection,
    difference,
    square,
    disc
  };
  Kind kind = Kind::sphere;
  std::vector<double> numbers = {};
  std::vector<Placing> placing = {};
  std::vector<Solid> operands = {};
  std::vector<std::string> names = {}; ///< of the glasses of cemented elements, or of the mesh

  [[nodiscard]] bool flat() const { return kind == Kind::square || kind == Kind::disc; }
};

/// A film on a surface, or the glass of a pane.
struct Layer {
  double thickness = 0.0; ///< in nm of a film, in mm of a pane; 0: there is none
  double index = 1.5;
};

/// What a solid is made of and how its surface is. All values are alike at all wavelengths, but for
/// the index of a glass of the catalogue.
struct Substance {
  enum class Kind : std::uint8_t {
    clear,   ///< lets light in by Fresnel's equations, scaled by reflectivity and transparency
    shares,  ///< lets light in by these two shares themselves
    mirror,  ///< opaque, mirrors the share `reflectivity`
    diffuse, ///< opaque, sends back the share `reflectivity` and gives off `emission`
    coated,  ///< diffuse below a coat
    pane,    ///< of flat shapes alone
    speckled ///< `share` of a clear surface is mirror instead
  };
  Kind kind = Kind::clear;
  std::string glass = {}; ///< a name of the catalogue; empty: `index`
  double index = 1.5;
  double reflectivity = 1.0, transparency = 1.0;
  double emission = 0.0;
  double absorption = 0.0; ///< per unit of length
  double roughness = 0.0;
  double dispersion_scale = 1.0;
  double share = 0.0;
  Layer layer = {}; ///< the film, the coat or the pane

  [[nodiscard]] bool lets_light_in() const {
    return kind == Kind::clear || kind == Kind::shares || kind == Kind::speckled;
  }
  [[nodiscard]] bool needs_path() const { return kind == Kind::diffuse || kind == Kind::coated; }
};

struct Item {
  Solid solid;
  Substance substance;
  int priority = 0;
};

/// Where the light of radiance 1 comes from: the background, or six squares around all.
enum class Surroundings : std::uint8_t { background, glowing_walls };

/// A scene that stands in light of radiance 1 from everywhere.
struct RandomScene {
  std::uint64_t seed = 0;
  std::vector<Item> items;
  Surroundings surroundings = Surroundings::background;
  std::array<double, 3> eye{0.0, 0.0, 9.0}, look_at{0.0, 0.0, 0.0};
  double field_of_view = 30.0;
  int bands = 3;
  bool exact = false, jitter = true;
  std::string more_settings = {};

  [[nodiscard]] bool needs_path() const;
  [[nodiscard]] bool has_rough() const;
};

/// `lossless`: no material takes light, or it gives off as much as it takes. Otherwise solids
/// absorb, and there are no materials other than those that `ReferenceWalk` knows.
enum class Losses : std::uint8_t { lossless, lossy };

/// The scene of a seed. Meshes are named by files in `folder`, see `write_meshes`.
[[nodiscard]] RandomScene random_scene(std::uint64_t seed, Losses losses,
                                       const std::string& folder);

/// The scene in the scene language. `settings` are further statements.
[[nodiscard]] std::string scene_text(const RandomScene& scene, const std::string& settings);

} // namespace abbe::stress
