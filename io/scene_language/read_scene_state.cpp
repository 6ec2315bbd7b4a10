#include "io/scene_language/read_scene_state.h"

#include "spectral/band_grid.h"
#include "spectral/rgb_spectrum.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace abbe {
namespace {

// A member added to the struct does not compile here until it is added to the comparison.
auto members(const Material& m) {
  const auto& [name, ambient, diffuse, specular, emission, emits_behind, exponent, reflectivity,
               transparency, fresnel, metal, texture, mixture, roughness, compensation, film, coat,
               pane] = m;
  return std::tie(name, ambient, diffuse, specular, emission, emits_behind, exponent, reflectivity,
                  transparency, fresnel, metal, texture, mixture, roughness, compensation, film,
                  coat, pane);
}

auto members(const Medium& m) {
  const auto& [name, index, absorption, drops] = m;
  return std::tie(name, index, absorption, drops);
}

/// The index of `value` in `values`, where it is added unless it is there. The search begins at
/// the end: mostly the state has not changed since the last shape.
template <class Value>
std::int32_t index_of(std::vector<Value>& values, const Value& value) {
  const auto found = std::find_if(values.rbegin(), values.rend(),
                                  [&](const Value& other) { return same(other, value); });
  if (found != values.rend()) return static_cast<std::int32_t>(values.rend() - found) - 1;
  values.push_back(value);
  return static_cast<std::int32_t>(values.size()) - 1;
}

ReadError not_positive(const SourcePosition& where, const Medium& medium) {
  const bool thesis = std::holds_alternative<ThesisScaled>(medium.index);
  return {where, "the solid's refractive index is not above 0 at every wavelength",
          thesis ? "speedOfLight is too small for this vnum" : "its dispersion is too strong",
          thesis ? "Raise speedOfLight or lower vnum"
                 : "Check the numbers of its index, or lower dispersionScale"};
}

void check_index(const SourcePosition& where, const Medium& medium) {
  for (double lambda_nm = kLowerNm; lambda_nm <= kUpperNm; lambda_nm += kSampleStepNm)
    if (!(refractive_index(medium.index, lambda_nm) > 0.0)) throw not_positive(where, medium);
}

MediumId medium_id(SceneState& state, const SourcePosition& where, const Medium& medium) {
  check_index(where, medium);
  if (medium.drops &&
      !(is_achromatic(medium.index) && refractive_index(medium.index, kLowerNm) == 1.0))
    throw ReadError(where, "drops hang in something with an index other than 1",
                    "they are known in air only", "Remove speedOfLight and vnum behind drops");
  return {index_of(state.scene.media, medium)};
}

} // namespace

Material default_finish() {
  Material finish;
  finish.ambient = Curve::constant(0.1);
  finish.diffuse = Curve::constant(0.8);
  return finish;
}

void warn_at(const SceneState& state, const SourcePosition& where, const std::string& message) {
  state.warn(to_string(where) + ": " + message);
}

bool is_transparent(const Material& finish) {
  return finish.transparency.constant_value() != 0.0;
}

bool same(const Material& a, const Material& b) {
  return members(a) == members(b);
}

bool same(const Medium& a, const Medium& b) {
  return members(a) == members(b);
}

MaterialId material_id(Scene& scene, const Material& finish) {
  return {index_of(scene.materials, finish)};
}

LinearRgb read_rgb(Arguments& arguments) {
  constexpr Range kComponent{"a component of a linear sRGB colour"};
  const double r = arguments.number(kComponent);
  const double g = arguments.number(kComponent);
  return {r, g, arguments.number(kComponent)};
}

Curve read_emission(SceneState& state, Arguments& arguments) {
  if (arguments.number_follows()) return rgb_emission(read_rgb(arguments));
  const Token name = arguments.name_token("a colour or the name of a spectrum");
  const Curve spectrum = look_up_light(state.libraries, name, state.warn);
  if (!arguments.number_follows()) return spectrum;
  return spectrum.scaled(arguments.number({"a factor on the spectrum"}));
}

Material filled_pane(const SourcePosition& where, const CurrentMaterial& material) {
  Material finish = material.finish;
  if (finish.pane) {
    check_index(where, material.medium);
    finish.pane->index = material.medium.index;
    finish.pane->absorption_per_mm = material.medium.absorption_per_mm;
  }
  return finish;
}

void place_shape(SceneState& state, const SourcePosition& where, Shape shape,
                 const Transform& to_world, const CurrentMaterial& material) {
  check_surface(where, material.finish);
  if (is_solid(shape)) check_solid(state.scene, where, material.finish);
  PlacedShape placed{std::move(shape),
                     to_world,
                     material_id(state.scene, filled_pane(where, material)),
                     {},
                     state.priority};
  if (is_solid(placed.shape) && is_transparent(material.finish))
    placed.medium = medium_id(state, where, material.medium);
  state.scene.shapes.push_back(std::move(placed));
}

} // namespace abbe
