// Materials: metallic-roughness and its extensions, as what light does at the surface.

#include "io/gltf/gltf_state.h"
#include "spectral/band_grid.h"
#include "spectral/dispersion.h"
#include "spectral/rgb_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace abbe {
namespace {

/// What a glTF says of a material, without its pictures.
struct Description {
  std::string name;
  LinearRgb base{1.0, 1.0, 1.0};
  double alpha = 1.0;
  double metallic = 1.0, roughness = 1.0;
  LinearRgb emission{0.0, 0.0, 0.0};
  double emission_factor = 1.0; ///< in candela per square metre
  bool double_sided = false;
  double ior = 1.5;
  double dispersion = 0.0; ///< 20 / V_d
  double transmission = 0.0;
  bool has_volume = false;
  LinearRgb attenuation{1.0, 1.0, 1.0};
  double attenuation_mm = 0.0; ///< the length behind which it is seen; 0: nothing is absorbed
  double specular = 1.0;
  LinearRgb specular_color{1.0, 1.0, 1.0};
  double clearcoat = 0.0, clearcoat_roughness = 0.0;
  double film = 0.0; ///< the share of the surface that has one
  double film_ior = 1.3, film_nm = 400.0;
};

constexpr std::array<std::string_view, 9> kExtensions{
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_ior",          "KHR_materials_dispersion",
    "KHR_materials_iridescence",  "KHR_materials_clearcoat",
    "KHR_materials_specular",     "KHR_materials_emissive_strength",
    "KHR_texture_transform"};

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMostEmission = 1e9;

LinearRgb color(const GltfValue& object, std::string_view name, const LinearRgb& otherwise) {
  const auto c = object.numbers<3>(name, {otherwise.r, otherwise.g, otherwise.b});
  for (const double part : c)
    if (!(part >= 0.0 && part <= kMostEmission))
      throw ReadError(object.find(name)->where(), fmt::format("{} has the part {:g}", name, part),
                      "light is never negative, nor without end", "Change it");
  return {c[0], c[1], c[2]};
}

/// Pictures in the place of numbers are refused.
void refuse_textures(GltfState& state, const GltfValue& object) {
  for (const std::string_view name : object.names())
    if (name.ends_with("Texture"))
      refuse(state, *object.find(name), fmt::format("the picture {}", name),
             "the factor beside it is taken alone");
}

void read_metallic_roughness(GltfState& state, const GltfValue& object, Description& d) {
  const auto base = object.numbers<4>("baseColorFactor", {1.0, 1.0, 1.0, 1.0});
  d.base = {base[0], base[1], base[2]};
  d.alpha = std::clamp(base[3], 0.0, 1.0);
  d.metallic = object.number("metallicFactor", 0.0, 1.0).value_or(1.0);
  d.roughness = object.number("roughnessFactor", 0.0, 1.0).value_or(1.0);
  refuse_textures(state, object);
}

void read_transparency(GltfState& state, const GltfValue& material, Description& d) {
  if (const auto object = material.extension("KHR_materials_transmission")) {
    d.transmission = object->number("transmissionFactor", 0.0, 1.0).value_or(0.0);
    refuse_textures(state, *object);
  }
  if (const auto object = material.extension("KHR_materials_volume")) {
    d.has_volume = object->number("thicknessFactor", 0.0).value_or(0.0) > 0.0;
    d.attenuation = color(*object, "attenuationColor", d.attenuation);
    const double metres = object->number("attenuationDistance", 0.0).value_or(kInfinite);
    d.attenuation_mm = std::isfinite(metres) ? 1000.0 * metres : 0.0;
    refuse_textures(state, *object);
  }
  if (const auto object = material.extension("KHR_materials_ior")) {
    d.ior = object->number("ior", 0.0, 10.0).value_or(1.5);
    if (d.ior < 1.0) {
      refuse(state, *object, fmt::format("an ior of {:g}", d.ior), "it is 1 or more");
      d.ior = 1.5;
    }
  }
  if (const auto object = material.extension("KHR_materials_dispersion"))
    d.dispersion = object->number("dispersion", 0.0, 1e4).value_or(0.0);
}

void read_layers(GltfState& state, const GltfValue& material, Description& d) {
  if (const auto object = material.extension("KHR_materials_specular")) {
    d.specular = object->number("specularFactor", 0.0, 1.0).value_or(1.0);
    d.specular_color = color(*object, "specularColorFactor", d.specular_color);
    refuse_textures(state, *object);
  }
  if (const auto object = material.extension("KHR_materials_clearcoat")) {
    d.clearcoat = object->number("clearcoatFactor", 0.0, 1.0).value_or(0.0);
    d.clearcoat_roughness = object->number("clearcoatRoughnessFactor", 0.0, 1.0).value_or(0.0);
    refuse_textures(state, *object);
  }
  if (const auto object = material.extension("KHR_materials_iridescence")) {
    d.film = object->number("iridescenceFactor", 0.0, 1.0).value_or(0.0);
    d.film_ior = object->number("iridescenceIor", 1.0, 10.0).value_or(1.3);
    d.film_nm = object->number("iridescenceThicknessMaximum", 0.0, 1e6).value_or(400.0);
    refuse_textures(state, *object);
  }
}

Description read_description(GltfState& state, const GltfValue& material) {
  Description d;
  d.name = material.string("name", "");
  refuse_extensions(state, material, kExtensions);
  refuse_textures(state, material);
  if (const auto object = material.find("pbrMetallicRoughness"))
    read_metallic_roughness(state, *object, d);
  d.emission = color(material, "emissiveFactor", d.emission);
  if (const auto object = material.extension("KHR_materials_emissive_strength"))
    d.emission_factor = object->number("emissiveStrength", 0.0, kMostEmission).value_or(1.0);
  d.double_sided = material.flag("doubleSided", false);
  read_transparency(state, material, d);
  read_layers(state, material, d);
  const std::string mode = material.string("alphaMode", "OPAQUE");
  if (mode == "MASK")
    d.alpha = d.alpha < material.number("alphaCutoff", 0.0).value_or(0.5) ? 0.0 : 1.0;
  else if (mode != "BLEND")
    d.alpha = 1.0;
  return d;
}

std::optional<GltfValue> material_value(GltfState& state, std::optional<std::size_t> index) {
  if (!index) return std::nullopt;
  return state.document.all("materials")[*index];
}

Description description_of(GltfState& state, std::optional<std::size_t> index) {
  const auto value = material_value(state, index);
  return value ? read_description(state, *value) : Description{};
}

Curve reflectance(const LinearRgb& c) {
  return rgb_reflectance(c);
}

/// The index of a boundary that reflects as much at normal incidence as one of `ior` does, times a
/// colour.
Dispersion tinted_index(double ior, const LinearRgb& tint) {
  const double most = std::max({tint.r, tint.g, tint.b});
  if (tint.r == 1.0 && tint.g == 1.0 && tint.b == 1.0) return ConstantIndex{ior};
  if (most == 0.0) return ConstantIndex{1.0};
  const Curve shape = reflectance({tint.r / most, tint.g / most, tint.b / most});
  const double f0 = most * std::pow((ior - 1.0) / (ior + 1.0), 2);
  const auto index = [&](double nm) {
    constexpr double kMostReflected = 0.66; // of an index of 9.7
    const double root = std::sqrt(std::min(f0 * shape.at(nm), kMostReflected));
    return (1.0 + root) / (1.0 - root);
  };
  if (shape.constant_value()) return ConstantIndex{index(kLineD_nm)};
  std::vector<double> nm, n;
  for (double at = 375.0; at <= 785.0; at += 5.0) {
    nm.push_back(at);
    n.push_back(index(at));
  }
  return tabulated_index(std::move(nm), std::move(n));
}

/// The materials of which a glTF's is mixed.
class Mixer {
public:
  Mixer(GltfState& state, const GltfValue& where, const Description& d, bool solid)
      : state_(state), where_(where), d_(d), solid_(solid) {
    if (d.emission_factor > 0.0) emission_ = rgb_emission(d.emission).scaled(d.emission_factor);
  }

  ShapeMaterial all() {
    const auto body = [&] {
      return mixed(d_.transmission, [&] { return glass(); }, [&] { return plastic(); });
    };
    const auto whole = [&] { return mixed(d_.metallic, [&] { return metal(); }, body); };
    return mixed(d_.alpha, whole, [&] { return nothing(); });
  }

private:
  /// The first material with this share, and the second.
  template <class First, class Second>
  ShapeMaterial mixed(double share, const First& first, const Second& second) {
    if (share <= 0.0) return second();
    if (share >= 1.0) return first();
    return state_.builder.mix(where_.where(), first(), second(), share);
  }

  ShapeMaterial finished(Material finish) const {
    finish.name = d_.name;
    finish.emission = emission_;
    finish.emits_behind = d_.double_sided;
    return {std::move(finish)};
  }

  ShapeMaterial diffuse() const {
    Material finish;
    finish.diffuse = reflectance(d_.base);
    return finished(std::move(finish));
  }
  ShapeMaterial coated(const Dispersion& index, double roughness) const {
    ShapeMaterial material = diffuse();
    if (is_achromatic(index) && refractive_index(index, kLineD_nm) == 1.0) return material;
    material.finish.coat = index;
    material.finish.roughness = roughness;
    return material;
  }
  /// A clear coat hides the boundary of the body below it, since the two have about one index.
  ShapeMaterial plastic() {
    if (d_.film > 0.0)
      refuse(state_, where_, "iridescence of what is neither metal nor transparent",
             "films lie on glass or metal");
    return mixed(
        d_.clearcoat, [&] { return coated(ConstantIndex{1.5}, d_.clearcoat_roughness); },
        [&] {
          return mixed(
              d_.specular,
              [&] { return coated(tinted_index(d_.ior, d_.specular_color), d_.roughness); },
              [&] { return diffuse(); });
        });
  }

  ShapeMaterial metal() {
    if (d_.clearcoat > 0.0)
      refuse(state_, where_, "a clear coat on metal", "coats lie on diffuse surfaces");
    const Curve color = reflectance(d_.base);
    std::vector<double> k; // of an index 1 - i k that reflects the colour at normal incidence
    for (int i = 0; i < kSampleCount; ++i) {
      const double r = std::clamp(color.at(sample_nm(i)), 0.0, 0.9999);
      k.push_back(2.0 * std::sqrt(r) / std::sqrt(1.0 - r));
    }
    Material finish;
    finish.reflectivity = Curve::constant(1.0);
    finish.metal = ConductorIndex{Curve::constant(1.0), Curve::samples81(std::move(k))};
    finish.roughness = d_.roughness;
    return with_film(finished(std::move(finish)));
  }

  ShapeMaterial with_film(const ShapeMaterial& bare) {
    return mixed(
        d_.film,
        [&] {
          ShapeMaterial covered = bare;
          covered.finish.film = ThinFilm{d_.film_nm, ConstantIndex{d_.film_ior}};
          return covered;
        },
        [&] { return bare; });
  }

  Medium medium() const {
    Medium medium{d_.name, ConstantIndex{d_.ior}, Curve::constant(0.0)};
    if (d_.dispersion > 0.0 && d_.ior > 1.0)
      medium.index = cauchy_of_abbe(d_.ior, 20.0 / d_.dispersion);
    if (d_.attenuation_mm > 0.0) {
      constexpr double kLeast = 1e-6; // passes nothing that could be seen
      const Curve color = reflectance(d_.attenuation);
      std::vector<double> absorption;
      for (int i = 0; i < kSampleCount; ++i)
        absorption.push_back(-std::log(std::clamp(color.at(sample_nm(i)), kLeast, 1.0)) /
                             d_.attenuation_mm);
      medium.absorption_per_mm = color.constant_value() ? Curve::constant(absorption[0])
                                                        : Curve::samples81(std::move(absorption));
    }
    return medium;
  }

  /// A solid's glass where the file gives it a volume and it is closed, else a pane.
  ShapeMaterial glass() {
    if (d_.clearcoat > 0.0)
      refuse(state_, where_, "a clear coat on glass", "coats lie on diffuse surfaces");
    Material finish;
    finish.reflectivity = Curve::constant(d_.specular);
    finish.transparency = reflectance(d_.base);
    if (d_.has_volume && solid_) {
      finish.roughness = d_.roughness;
      ShapeMaterial material = finished(std::move(finish));
      material.medium = medium();
      return with_film(material);
    }
    if (d_.roughness >= 0.01)
      refuse(state_, where_, fmt::format("a thin wall of roughness {:g}", d_.roughness),
             "panes are smooth; KHR_materials_volume makes a solid of a closed mesh");
    if (d_.film > 0.0)
      refuse(state_, where_, "iridescence of a thin wall", "panes have bare faces");
    finish.pane = ThinPane{};
    ShapeMaterial material = finished(std::move(finish));
    material.medium = medium();
    return material;
  }

  /// What stands where alpha lets everything through.
  ShapeMaterial nothing() const {
    Material finish;
    finish.name = d_.name;
    finish.transparency = Curve::constant(1.0);
    return {std::move(finish), {"", ConstantIndex{1.0}, Curve::constant(0.0)}};
  }

  GltfState& state_;
  const GltfValue& where_;
  const Description& d_;
  bool solid_;
  Curve emission_ = Curve::constant(0.0);
};

} // namespace

bool fills_solid(GltfState& state, std::optional<std::size_t> index) {
  const Description d = description_of(state, index);
  return d.has_volume && d.transmission > 0.0 && d.metallic < 1.0;
}

bool is_invisible(GltfState& state, std::optional<std::size_t> index) {
  return description_of(state, index).alpha <= 0.0;
}

const ShapeMaterial& gltf_material(GltfState& state, std::optional<std::size_t> index, bool solid) {
  const std::pair key(index, solid);
  const auto known = state.materials.find(key);
  if (known != state.materials.end()) return known->second;
  const Description d = description_of(state, index);
  const GltfValue where = material_value(state, index).value_or(state.document.root());
  if (d.has_volume && d.transmission > 0.0 && !solid)
    state.warn(fmt::format("{}: \"{}\" is on a mesh that is not closed, which is taken as a thin "
                           "pane of it",
                           to_string(where.where()), d.name));
  return state.materials.emplace(key, Mixer(state, where, d, solid).all()).first->second;
}

} // namespace abbe
