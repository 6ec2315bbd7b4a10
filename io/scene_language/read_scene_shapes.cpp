// A shape stands where the current transform puts it, with the current material:
//
//   sphere
//   push translate 3 0 0 scale 1 2 1 cube pop

#include "geometry/meshes/overlap.h"
#include "io/scene_language/read_scene_state.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <variant>

namespace abbe {
namespace {

void add_solid(SceneState& state, const Arguments& arguments, Convex solid) {
  const SourcePosition& where = arguments.keyword().where;
  if (state.boolean)
    return add_operand(state, {std::move(solid), state.transform, operand_finish(state, where)});
  Shape shape = std::visit([](auto& s) { return Shape(std::move(s)); }, solid);
  place_shape(state, where, std::move(shape), state.transform, state.material);
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

/// Bodies that overlap have faces inside of each other, at which glass would bend light.
void warn_of_overlap(const SourcePosition& where, const Mesh& mesh, const Warn& warn) {
  const auto place = find_overlap(mesh);
  if (!place) return;
  warn(fmt::format("{}: bodies of the mesh overlap, as at ({:g} {:g} {:g}), and glass bends light "
                   "at their faces there. Give each body a file of its own, so that they are one",
                   to_string(where), place->x, place->y, place->z));
}

void read_triangles(SceneState& state, Arguments& arguments) {
  const SourcePosition& where = arguments.keyword().where;
  if (state.boolean)
    throw ReadError(where, "mesh cannot be an operand", "booleans combine convex solids",
                    "Give it a place of its own, with a priority where it overlaps others");
  add_input(state.files, arguments.reader().peek());
  const MendedMesh& read = read_mesh(arguments, state.meshes, state.warn);
  if (!read.mesh.is_closed() && needs_inside(state.scene, state.material))
    throw open_mesh_error(where, read.open);
  if (needs_inside(state.scene, state.material) && state.filled_meshes.insert(&read).second)
    warn_of_overlap(where, read.mesh, state.warn);
  place_shape(state, where, read.mesh, state.transform, state.material);
}

constexpr std::array kShapeKeywords{
    SceneKeyword{"sphere", read_sphere, true},
    SceneKeyword{"cube", read_cube, true},
    SceneKeyword{"prism", read_prism, true},
    SceneKeyword{"cylinder", read_cylinder, true},
    SceneKeyword{"cone", read_cone, true},
    SceneKeyword{"taperedCylinder s", read_tapered_cylinder, true},
    SceneKeyword{"polyhedron planes|vertices n ...", read_convex_polyhedron, true},
    SceneKeyword{"mesh FILE", read_triangles, true},
    SceneKeyword{"square", read_flat<Square>, true},
    SceneKeyword{"disc", read_flat<Disc>, true},
    SceneKeyword{"plane", read_flat<Plane>, true},
};

} // namespace

std::span<const SceneKeyword> shape_keywords() {
  return kShapeKeywords;
}

} // namespace abbe
