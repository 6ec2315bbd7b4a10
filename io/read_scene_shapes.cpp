// A shape stands where the current transform puts it, with the current material:
//
//   sphere
//   push translate 3 0 0 scale 1 2 1 cube pop

#include "io/read_scene_state.h"

#include <array>
#include <utility>
#include <variant>

namespace abbe {
namespace {

/// The solid becomes an operand of the open boolean.
void add_operand(SceneState& state, const Arguments& arguments, Convex solid) {
  BooleanScope& scope = *state.boolean;
  const CurrentMaterial& own = state.material;
  const MaterialId id = material_id(state.scene, own.finish);
  const bool other_filling =
      is_transparent(own.finish) && scope.filling && !same(own.medium, *scope.filling);
  if (other_filling)
    warn_at(state, arguments.keyword().where,
            "what fills this operand is ignored (one medium fills the whole solid, that of the "
            "outermost boolean)");
  scope.operands.emplace_back(std::move(solid), state.transform,
                              id == scope.whole ? MaterialId{} : id);
  state.material = scope.material;
}

void add_solid(SceneState& state, const Arguments& arguments, Convex solid) {
  if (state.boolean) return add_operand(state, arguments, std::move(solid));
  Shape shape = std::visit([](auto& s) { return Shape(std::move(s)); }, solid);
  place_shape(state, arguments.keyword().where, std::move(shape), state.transform, state.material);
}

void read_sphere(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, Sphere{});
}

void read_cube(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, Box{});
}

void read_prism(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, thesis_prism());
}

void read_tapered_cylinder(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, TaperedCylinder{arguments.number({"the radius at z = 1"})});
}

void read_cylinder(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, TaperedCylinder{1.0});
}

void read_cone(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, TaperedCylinder{0.0});
}

void read_convex_polyhedron(SceneState& state, Arguments& arguments) {
  add_solid(state, arguments, read_polyhedron(arguments));
}

template <FlatShape S>
void read_flat(SceneState& state, Arguments& arguments) {
  if (state.boolean)
    throw ReadError(arguments.keyword().where,
                    std::string(arguments.name()) + " cannot be an operand",
                    "it has no inside to combine", "Use a flat cube, or another solid");
  place_shape(state, arguments.keyword().where, S{}, state.transform, state.material);
}

constexpr std::array kKeywords{
    SceneKeyword{"sphere", read_sphere, true},
    SceneKeyword{"cube", read_cube, true},
    SceneKeyword{"prism", read_prism, true},
    SceneKeyword{"cylinder", read_cylinder, true},
    SceneKeyword{"cone", read_cone, true},
    SceneKeyword{"taperedCylinder s", read_tapered_cylinder, true},
    SceneKeyword{"polyhedron planes|vertices n ...", read_convex_polyhedron, true},
    SceneKeyword{"square", read_flat<Square>, true},
    SceneKeyword{"disc", read_flat<Disc>, true},
    SceneKeyword{"plane", read_flat<Plane>, true},
};

} // namespace

std::span<const SceneKeyword> shape_keywords() {
  return kKeywords;
}

} // namespace abbe
