#include "io/building/shape_material.h"

#include "core/scene/quantity_limits.h"
#include "core/scene/scene.h"
#include "spectral/band_grid.h"

#include <fmt/format.h>

namespace abbe {
namespace {

ReadError impossible_index(const SourcePosition& where, const Medium& medium, double lambda_nm,
                           double n) {
  const bool thesis = std::holds_alternative<ThesisScaled>(medium.index);
  const auto number = n > 0.0 && n < kMostIndex ? fmt::format("{:.4g}", n) : fmt::format("{:g}", n);
  return {
      where,
      fmt::format("the solid's refractive index is {} at {:g} nm, which no clear medium has",
                  number, lambda_nm),
      fmt::format("it must lie between {:g} and {:g} at every wavelength", kLeastIndex, kMostIndex),
      thesis ? "Check speedOfLight and vnum"
             : "Check the numbers of its index, or lower dispersionScale"};
}

void check_index(const SourcePosition& where, const Medium& medium) {
  for (double lambda_nm = kLowerNm; lambda_nm <= kUpperNm; lambda_nm += kSampleStepNm) {
    const double n = refractive_index(medium.index, lambda_nm);
    if (!(n >= kLeastIndex && n <= kMostIndex)) throw impossible_index(where, medium, lambda_nm, n);
  }
}

} // namespace

Material default_finish() {
  Material finish;
  finish.ambient = Curve::constant(0.1);
  finish.diffuse = Curve::constant(0.8);
  return finish;
}

ShapeMaterial default_material() {
  ShapeMaterial material;
  material.default_ambient = material.default_diffuse = true;
  return material;
}

ShapeMaterial clear_material(const Medium& filling) {
  Material clear;
  clear.reflectivity = clear.transparency = Curve::constant(1.0);
  return {clear, filling};
}

ShapeMaterial clear_glass(const Glass& glass) {
  ShapeMaterial clear = clear_material({glass.name, glass.dispersion, Curve::constant(0.0)});
  clear.finish.name = glass.name;
  return clear;
}

ShapeMaterial bare_metal(const Metal& metal) {
  Material mirror;
  mirror.name = metal.name;
  mirror.reflectivity = Curve::constant(1.0);
  mirror.metal = ConductorIndex{metal.n, metal.k};
  return {mirror, ShapeMaterial{}.medium};
}

bool is_transparent(const Material& finish) {
  return finish.transparency.constant_value() != 0.0;
}

bool needs_inside(const Scene& scene, const ShapeMaterial& material) {
  const Medium& medium = material.medium;
  if (is_achromatic(medium.index) && refractive_index(medium.index, kLowerNm) == 1.0) return false;
  if (const auto& mixture = material.finish.mixture)
    return needs_inside(scene, {scene.materials[mixture->first.index()], medium}) ||
           needs_inside(scene, {scene.materials[mixture->second.index()], medium});
  return is_transparent(material.finish) && material.finish.fresnel && !material.finish.pane;
}

void check_surface(const SourcePosition& where, const Material& finish) {
  if (finish.pane && (finish.film || finish.roughness > 0.0 || !finish.fresnel))
    throw ReadError(where,
                    fmt::format("{} does not go with thinGlass", finish.film      ? "thinFilm"
                                                                 : finish.fresnel ? "roughness"
                                                                                  : "fresnel off"),
                    "a pane has two smooth and bare faces, which reflect by Fresnel's equations",
                    "Remove it, or give a solid of glass");
  const bool boundary = finish.metal || is_transparent(finish);
  if (finish.coat && boundary)
    throw ReadError(where, "coat does not go with glass or metal",
                    "it lies on the diffuse part of an opaque surface",
                    "Give defaultMaterials before it, or thinFilm instead");
  if (finish.film && !boundary)
    throw ReadError(where, "thinFilm lies on neither glass nor metal",
                    "an opaque surface without an index has no light to interfere with",
                    "Give a glass, a metal or a transparency, or coat instead");
}

void check_solid(const Scene& scene, const SourcePosition& where, const Material& finish) {
  if (finish.mixture) {
    check_solid(scene, where, scene.materials[finish.mixture->first.index()]);
    check_solid(scene, where, scene.materials[finish.mixture->second.index()]);
  }
  if (finish.pane)
    throw ReadError(where, "thinGlass does not go with a solid",
                    "it is a pane without an inside, for squares, discs, planes and open meshes",
                    "Give glass instead, or one of those shapes");
}

void check_sheet(const Scene& scene, const SourcePosition& where, const ShapeMaterial& material) {
  if (needs_inside(scene, material))
    throw ReadError(where, "a transparent material does not go with a sheet",
                    "squares, discs, planes and open meshes have no inside that it could fill",
                    "Give thinGlass, a pane of some thickness, or a flat cube");
}

Material shape_finish(const SourcePosition& where, const ShapeMaterial& material) {
  Material finish = material.finish;
  if (is_transparent(finish)) {
    if (material.default_ambient) finish.ambient = Curve::constant(0.0);
    if (material.default_diffuse) finish.diffuse = Curve::constant(0.0);
  }
  if (finish.pane) {
    check_index(where, material.medium);
    finish.pane->index = material.medium.index;
    finish.pane->absorption_per_mm = material.medium.absorption_per_mm;
  }
  return finish;
}

void check_medium(const SourcePosition& where, const Medium& medium) {
  check_index(where, medium);
  if (medium.drops &&
      !(is_achromatic(medium.index) && refractive_index(medium.index, kLowerNm) == 1.0))
    throw ReadError(where, "drops hang in something with an index other than 1",
                    "they are known in air only", "Remove speedOfLight and vnum behind drops");
}

} // namespace abbe
