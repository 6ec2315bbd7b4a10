// The current material applies to the shapes that follow:
//
//   UseMaterial StrongOrangeYellow     ! from the material library
//
//   defaultMaterials                   ! Hill's default, then what differs from it
//   diffuse 0.7 0.2 0.2                ! linear sRGB
//   reflectivity 0.3
//
//   glass N-BK7                        ! clear glass of the catalogue
//   absorption 0.01                    ! per mm
//
//   thinGlass 4 N-BK7                  ! a window of 4 mm, of which this is all

#include "core/scene/quantity_limits.h"
#include "io/libraries/read_absorption.h"
#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "io/libraries/read_spectrum.h"
#include "io/scene_language/read_scene_state.h"
#include "spectral/observer.h"
#include "spectral/rgb_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace abbe {
namespace {

constexpr Range kFraction{"a fraction of the light", 0.0, 1.0};

template <Curve Material::* part>
void read_part(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  if (name_follows(arguments)) {
    const Token file = arguments.name_token("the name of a file");
    if (!is_spectrum_file(file.text))
      throw ReadError(file.where, shown(file) + " is neither a colour nor a file with a spectrum",
                      arguments.takes(), "Give three numbers, or a .csv, .tsv, .sp or .spdx file");
    add_input(state.files, file);
    state.material.finish.*part = read_reflectance(file, state.warn);
  } else {
    state.material.finish.*part = rgb_reflectance(read_fraction_rgb(state, arguments));
  }
  if (part == &Material::ambient) state.material.default_ambient = false;
  if (part != &Material::diffuse) return;
  state.material.default_diffuse = false;
  state.material.finish.texture.reset();
}

void read_emissive(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.emission = read_emission(state, arguments);
}

/// The luminance of what the surface gives off.
void read_nit(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  const double luminance =
      arguments.number({"a luminance in candela per square metre", 0.0, kMostLight});
  Curve& emission = state.material.finish.emission;
  const double y = to_xyz(emission).y;
  if (!(y > 0.0))
    throw ReadError(arguments.keyword().where, "nit stands where nothing is given off",
                    "it says how bright the light of emissive is",
                    "Give emissive before it, such as emissive D65");
  emission = emission.scaled(luminance / y);
}

void read_emissive_sides(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.emits_behind = arguments.choice<bool>({{"both", true}, {"front", false}});
}

void read_exponent(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.specular_exponent =
      arguments.number({"the exponent of the highlight", 0.0, 1e9});
}

/// A share of light, one number or by wavelength.
Curve read_share(SceneState& state, Arguments& arguments) {
  if (!name_follows(arguments) || !is_spectrum_file(arguments.reader().peek().text))
    return Curve::constant(arguments.number(kFraction));
  const Token file = arguments.name_token("the name of a file");
  add_input(state.files, file);
  return read_reflectance(file, state.warn);
}

void read_reflectivity(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.reflectivity = read_share(state, arguments);
}

void read_speed_of_light(SceneState& state, Arguments& arguments) {
  const double n = arguments.number(kIndexRange);
  const auto* law = std::get_if<ThesisScaled>(&state.material.medium.index);
  state.material.medium.index = ThesisScaled{n, law ? law->v_number : 0.0};
}

void read_vnum(SceneState& state, Arguments& arguments) {
  auto* law = std::get_if<ThesisScaled>(&state.material.medium.index);
  if (!law)
    throw ReadError(arguments.keyword().where, "vnum does not go with glass",
                    "what fills the solid has its own dispersion",
                    "Remove it, or give speedOfLight before it");
  law->v_number = arguments.number(kVNumberRange);
}

void read_absorption(SceneState& state, Arguments& arguments) {
  state.material.medium.absorption_per_mm = Curve::constant(arguments.number(kAbsorptionRange));
}

template <Curve (*read_curve)(Arguments&)>
void read_absorption_by(SceneState& state, Arguments& arguments) {
  state.material.medium.absorption_per_mm = read_curve(arguments);
}

void read_fresnel(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  state.material.finish.fresnel = arguments.on_off();
}

void read_default_materials(SceneState& state, Arguments&) {
  state.material = default_material();
}

void read_glass_keyword(SceneState& state, Arguments& arguments) {
  state.material = read_clear_glass(state, arguments);
}

/// Clear glass of a law that is written out.
template <WrittenIndex (*read_law)(Arguments&, const Warn&)>
void read_law_glass(SceneState& state, Arguments& arguments) {
  WrittenIndex index = read_law(arguments, state.warn);
  state.material =
      clear_material({std::move(index.name), std::move(index.law), Curve::constant(0.0)});
}

/// A material of its own, as the keyword `glass` gives.
void read_thin_glass(SceneState& state, Arguments& arguments) {
  constexpr Range kThickness{"a thickness in mm", 0.0, 1e6};
  const double mm = arguments.number(kThickness);
  state.material = clear_material({"", read_index(state, arguments), Curve::constant(0.0)});
  state.material.finish.pane = ThinPane{mm, ConstantIndex{1.0}, Curve::constant(0.0)};
}

void read_dispersion_scale(SceneState& state, Arguments& arguments) {
  Dispersion& index = state.material.medium.index;
  index = exaggerated(index, arguments.number(kDispersionScaleRange));
}

void read_metal_mirror(SceneState& state, Arguments& arguments) {
  if (const Token& file = arguments.reader().peek(); is_refractiveindex_file(file.text)) {
    add_input(state.files, file);
    ConductorIndex index = read_refractiveindex_metal(file);
    state.material = bare_metal({file.text, std::move(index.n), std::move(index.k)});
    arguments.reader().next();
    return;
  }
  state.material = bare_metal(read_metal(arguments));
}

/// A metal lets no light in.
void read_transparency(SceneState& state, Arguments& arguments) {
  require_unmixed(state, arguments);
  const Curve share = read_share(state, arguments);
  if (state.material.finish.metal && !share.zero())
    throw ReadError(arguments.keyword().where, "transparency does not go with metal",
                    "what a metal does not reflect it takes in", "Give a glass, or remove it");
  state.material.finish.transparency = share;
}

void read_use_material(SceneState& state, Arguments& arguments) {
  const Token name = arguments.name_token("the name of a material");
  state.material = named_material(state, arguments.keyword().where, name);
}

void read_priority(SceneState& state, Arguments& arguments) {
  constexpr double kMost = std::numeric_limits<int>::max();
  state.priority = static_cast<int>(arguments.whole_number({"a rank", -kMost, kMost}));
}

constexpr std::array kMaterialKeywords{
    SceneKeyword{"UseMaterial NAME", read_use_material, true},
    SceneKeyword{"ambient r g b | FILE", read_part<&Material::ambient>, true},
    SceneKeyword{"diffuse r g b | FILE", read_part<&Material::diffuse>, true},
    SceneKeyword{"specular r g b | FILE", read_part<&Material::specular>, true},
    SceneKeyword{"emissive r g b | SPECTRUM [factor]", read_emissive, true},
    SceneKeyword{"nit x", read_nit, true},
    SceneKeyword{"emissiveSides both|front", read_emissive_sides, true},
    SceneKeyword{"specularExponent e", read_exponent, true},
    SceneKeyword{"reflectivity x | FILE", read_reflectivity, true},
    SceneKeyword{"transparency x | FILE", read_transparency, true},
    SceneKeyword{"speedOfLight n", read_speed_of_light, true},
    SceneKeyword{"vnum v", read_vnum, true},
    SceneKeyword{"fresnel on|off", read_fresnel, true},
    SceneKeyword{"defaultMaterials", read_default_materials, true},
    SceneKeyword{"glass NAME|FILE", read_glass_keyword, true},
    SceneKeyword{"thinGlass thickness n|GLASS", read_thin_glass, true},
    SceneKeyword{"metal NAME|FILE", read_metal_mirror, true},
    SceneKeyword{kCauchyUsage, read_law_glass<read_cauchy>, true},
    SceneKeyword{kAbbeUsage, read_law_glass<read_abbe>, true},
    SceneKeyword{kIndexTableUsage, read_law_glass<read_index_table>, true},
    SceneKeyword{kIndexFitUsage, read_law_glass<read_index_fit>, true},
    SceneKeyword{kQuartzUsage, read_law_glass<read_quartz>, true},
    SceneKeyword{kDispersionScaleUsage, read_dispersion_scale, true},
    SceneKeyword{"absorption x", read_absorption, true},
    SceneKeyword{kAbsorptionTableUsage, read_absorption_by<read_absorption_table>, true},
    SceneKeyword{kInternalTransmittanceUsage, read_absorption_by<read_internal_transmittance>,
                 true},
    SceneKeyword{"priority n", read_priority},
};

} // namespace

LinearRgb read_fraction_rgb(SceneState& state, Arguments& arguments) {
  const LinearRgb color = read_rgb(arguments);
  if (std::max({color.r, color.g, color.b}) > 1.0)
    warn_at(state, arguments.keyword().where,
            fmt::format("{} above 1 counts as 1 (nothing reflects more than it gets)",
                        arguments.name()));
  return color;
}

Dispersion read_index(SceneState& state, Arguments& arguments) {
  if (auto code = read_glass_code(arguments)) return std::move(code->law);
  if (arguments.number_follows()) return ConstantIndex{arguments.number(kIndexRange)};
  return read_clear_glass(state, arguments).medium.index;
}

CurrentMaterial read_clear_glass(SceneState& state, Arguments& arguments) {
  if (auto code = read_glass_code(arguments))
    return clear_material({std::move(code->name), std::move(code->law), Curve::constant(0.0)});
  const SourcePosition where = arguments.keyword().where;
  if (const FileGlass* own = look_up_glass(state.libraries, arguments.reader().peek())) {
    arguments.reader().next();
    state.builder.warn_of_extrapolation(where, own->glass, state.warn);
    return clear_material({own->glass.name, own->glass.dispersion, own->absorption_per_mm});
  }
  const Glass& glass = read_glass(arguments);
  state.builder.warn_of_extrapolation(where, glass, state.warn);
  return clear_glass(glass);
}

std::span<const SceneKeyword> material_keywords() {
  return kMaterialKeywords;
}

} // namespace abbe
