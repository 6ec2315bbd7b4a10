// Materials, textures and media:
//
//   Texture "chk" "spectrum" "checkerboard" "float uscale" 8 "float vscale" 8
//   Material "diffuse" "texture reflectance" "chk"
//   Material "dielectric" "float eta" 1.5
//   MakeNamedMedium "ink" "string type" "homogeneous" "rgb sigma_a" [ 1 2 3 ] "rgb sigma_s" [ 0 0 0
//   ]

#include "io/images/read_image.h"
#include "io/pbrt/pbrt_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace abbe {
namespace {

/// The roughness whose square is the width of the facets' slopes. pbrt takes the root of its own
/// for that, unless it is told not to.
double read_roughness(PbrtState& state, PbrtParameters& parameters) {
  const bool remapped = parameters.flag("remaproughness", true);
  const auto number = [&](std::string_view name) -> std::optional<double> {
    const PbrtParameter* found = parameters.find(name);
    if (!found) return std::nullopt;
    if (found->type != "texture") return parameters.number(name);
    const auto texture =
        state.float_textures.find(found->strings.empty() ? std::string() : found->strings[0]);
    if (texture != state.float_textures.end()) return texture->second;
    refuse(state, found->where, fmt::format("{} by a texture that is no constant", name),
           "a roughness is the same everywhere");
    return 0.0;
  };
  const double both = number("roughness").value_or(0.0);
  const double u = number("uroughness").value_or(both), v = number("vroughness").value_or(both);
  if (u != v)
    refuse(state,
           parameters.find("uroughness") ? parameters.find("uroughness")->where
                                         : parameters.find("vroughness")->where,
           "a roughness that differs by direction", "the geometric mean would be taken");
  const double alpha = remapped ? std::sqrt(std::sqrt(u * v)) : std::sqrt(u * v);
  return std::min(1.0, std::sqrt(alpha));
}

void set_diffuse(Material& finish, const PbrtTexture& texture) {
  finish.diffuse = texture.value;
  finish.texture = texture.pattern;
}

ShapeMaterial diffuse_material(const PbrtTexture& reflectance) {
  ShapeMaterial material = default_material();
  material.default_ambient = material.default_diffuse = false;
  material.finish.ambient = Curve::constant(0.0);
  set_diffuse(material.finish, reflectance);
  return material;
}

PbrtMaterial read_conductor(PbrtState& state, PbrtParameters& parameters) {
  PbrtMaterial material;
  const PbrtTexture reflectance = read_reflectance(state, parameters, "reflectance", -1.0);
  if (reflectance.pattern)
    refuse(state, parameters.find("reflectance")->where, "a pattern on a conductor",
           "one reflectance is read");
  const bool by_reflectance = reflectance.value.constant_value() != -1.0;
  Metal metal = *find_metal("Cu");
  if (const auto n = read_plain_spectrum(state, parameters, "eta")) metal.n = *n;
  if (const auto k = read_plain_spectrum(state, parameters, "k")) metal.k = *k;
  material.shape = bare_metal(metal);
  if (by_reflectance) { // as pbrt has it: eta = 1 and k = 2 sqrt(r) / sqrt(1 - r)
    std::vector<double> k;
    for (int i = 0; i < 81; ++i) {
      const double r = std::clamp(reflectance.value.at(380.0 + 5.0 * i), 0.0, 0.9999);
      k.push_back(2.0 * std::sqrt(r) / std::sqrt(1.0 - r));
    }
    material.shape.finish.metal = ConductorIndex{Curve::constant(1.0), Curve::samples81(k)};
  }
  material.shape.finish.roughness = read_roughness(state, parameters);
  return material;
}

} // namespace

PbrtMaterial default_pbrt_material() {
  return {diffuse_material({Curve::constant(0.5), std::nullopt})};
}

PbrtMaterial read_pbrt_material(PbrtState& state, const SourcePosition& where,
                                const std::string& type, PbrtParameters& parameters) {
  parameters.ignore({"type"});
  PbrtMaterial material;
  if (type == "diffuse") {
    material.shape = diffuse_material(read_reflectance(state, parameters, "reflectance", 0.5));
  } else if (type == "dielectric" || type == "thindielectric") {
    material.shape =
        clear_material({type, read_index(state, parameters, "eta", 1.5), Curve::constant(0.0)});
    material.fills = type == "dielectric";
    if (material.fills)
      material.shape.finish.roughness = read_roughness(state, parameters);
    else
      material.shape.finish.pane = ThinPane{1.0, ConstantIndex{1.0}, Curve::constant(0.0)};
  } else if (type == "conductor") {
    material = read_conductor(state, parameters);
  } else if (type == "coateddiffuse") {
    material.shape = diffuse_material(read_reflectance(state, parameters, "reflectance", 0.5));
    material.shape.finish.coat = read_index(state, parameters, "eta", 1.5);
    material.shape.finish.roughness = read_roughness(state, parameters);
    parameters.ignore({"thickness", "maxdepth", "nsamples"});
  } else if (type == "interface" || type == "none" || type.empty()) {
    material.shape = default_material();
    material.nothing = true;
  } else {
    refuse(state, where, fmt::format("the material \"{}\"", type),
           "diffuse, dielectric, thindielectric, conductor, coateddiffuse and interface are read; "
           "a grey diffuse one would stand for it");
    material.shape = diffuse_material({Curve::constant(0.5), std::nullopt});
    return material;
  }
  refuse_unused(state, parameters);
  return material;
}

void read_pbrt_texture(PbrtState& state, const SourcePosition& where, PbrtParameters& parameters,
                       const std::vector<std::string>& words) {
  const std::string &name = words[0], &type = words[1], &kind = words[2];
  if (type == "float") {
    if (kind != "constant")
      return refuse(state, where, fmt::format("the float texture \"{}\"", kind),
                    "only constant ones are read");
    state.float_textures[name] = parameters.number("value", 1.0);
    return refuse_unused(state, parameters);
  }
  PbrtTexture texture;
  if (kind == "constant") {
    texture = read_reflectance(state, parameters, "value", 1.0);
  } else if (kind == "scale") {
    texture = read_reflectance(state, parameters, "tex", 1.0);
    const double factor = parameters.number("scale", 1.0);
    if (texture.pattern) refuse(state, where, "a scaled pattern", "a constant is scaled");
    texture.value = within_one(texture.value.scaled(factor));
  } else if (kind == "checkerboard") {
    CheckerTexture checker;
    checker.across = parameters.number("uscale", 1.0);
    checker.up = parameters.number("vscale", 1.0);
    const PbrtTexture first = read_reflectance(state, parameters, "tex1", 1.0);
    const PbrtTexture second = read_reflectance(state, parameters, "tex2", 0.0);
    if (first.pattern || second.pattern)
      refuse(state, where, "a pattern within a pattern", "fields have one colour each");
    if (parameters.number("udelta", 0.0) != 0.0 || parameters.number("vdelta", 0.0) != 0.0 ||
        parameters.number("dimension", 2.0) != 2.0 || parameters.string("mapping", "uv") != "uv")
      refuse(state, where, "a checkerboard that is not laid by u and v alone",
             "its mapping is uv, without an offset");
    checker.first = first.value;
    checker.second = second.value;
    texture.pattern = checker;
  } else if (kind == "imagemap") {
    const PbrtParameter* file = parameters.find("filename");
    if (!file || file->strings.size() != 1)
      throw ReadError(where, "imagemap has no filename", "it names a picture", "Add it");
    const std::filesystem::path path = state.folder / file->strings[0];
    // The reader of pictures finds names from the folder of the file that names them.
    const std::filesystem::path from = std::filesystem::path(file->where.file).parent_path();
    const std::string relative = path.lexically_relative(from).string();
    const Token token{TokenKind::quoted, relative.empty() ? path.string() : relative, file->where};
    state.files.push_back(path);
    texture.pattern =
        ImageTexture{state.builder.add_image(path, [&] { return read_image(token, state.warn); })};
    parameters.ignore({"filter", "wrap", "encoding", "maxanisotropy"});
    if (parameters.number("uscale", 1.0) != 1.0 || parameters.number("vscale", 1.0) != 1.0 ||
        parameters.number("scale", 1.0) != 1.0 || parameters.flag("invert", false))
      refuse(state, where, "a picture that is scaled or inverted", "it fills 0 to 1 in u and v");
  } else {
    refuse(state, where, fmt::format("the texture \"{}\"", kind),
           "constant, scale, checkerboard and imagemap are read");
    state.textures[name] = {Curve::constant(0.5), std::nullopt};
    return;
  }
  refuse_unused(state, parameters);
  state.textures[name] = std::move(texture);
}

/// Scattering media are refused. Absorption counts along the scene's unit of length.
void read_pbrt_medium(PbrtState& state, const SourcePosition& where, const std::string& name,
                      PbrtParameters& parameters) {
  const std::string type = parameters.string("type", "homogeneous");
  if (type != "homogeneous")
    refuse(state, where, fmt::format("the medium \"{}\"", type), "only homogeneous ones are read");
  const double scale = parameters.number("scale", 1.0);
  const auto absorbs = read_plain_spectrum(state, parameters, "sigma_a");
  const auto scatters = read_plain_spectrum(state, parameters, "sigma_s");
  if (!scatters || !scatters->zero() || !absorbs)
    refuse(state, where, "a medium that scatters",
           "one that absorbs only has sigma_a, and 0 for sigma_s");
  bool negative = scale < 0.0;
  for (int k = 0; absorbs && k < kSampleCount; ++k)
    negative = negative || absorbs->at(sample_nm(k)) < 0.0;
  if (negative)
    throw ReadError(where, fmt::format("the medium \"{}\" gives light", name),
                    "its absorption or scale is below 0", "Give 0 or more");
  if (absorbs) state.media[name].absorption = absorbs->scaled(scale);
  parameters.ignore({"g", "preset"});
  refuse_unused(state, parameters);
}

} // namespace abbe
