#include "geometry/shape.h"

namespace abbe {

bool is_solid(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->is_closed();
  return std::visit([]<class S>(const S&) { return !FlatShape<S>; }, shape);
}

bool is_bounded(const Shape& shape) {
  return !std::holds_alternative<Plane>(shape);
}

bool contains(const PlacedShape& placed, const dvec3& world_point) {
  const dvec3 p = placed.to_world.inverse_point(world_point);
  return std::visit(
      [&](const auto& shape) {
        if constexpr (requires { signed_distance(shape, p); })
          return signed_distance(shape, p) < 0.0;
        else
          return false;
      },
      placed.shape);
}

Bounds bounds(const PlacedShape& placed) {
  return std::visit([&](const auto& shape) { return bounds(shape, placed.to_world); },
                    placed.shape);
}

std::optional<ShapeCrossing> next_crossing(const CsgTree& tree, const LocalRay& ray,
                                           const ShapeState& state) {
  CsgContact contact;
  if (state.touching) {
    const bool flipped = tree.leaves()[static_cast<std::size_t>(state.face.leaf)].flipped;
    const bool inside_leaf = state.inside != flipped;
    contact = {state.face.leaf, {state.face.face, inside_leaf ? Side::inside : Side::outside}};
  }
  thread_local std::vector<Interval> intervals;
  intervals.clear();
  intersect(tree, ray, state.touching ? &contact : nullptr, intervals);

  if (state.inside) {
    const Root* just_left = nullptr; // an exit that rounding has put behind the origin
    for (const Interval& i : intervals) {
      if (i.exit.t < 0.0) {
        if (-i.exit.t <= i.exit.t_error) just_left = &i.exit;
        continue;
      }
      if (i.enter.t > i.enter.t_error) break; // a later part of the solid
      return ShapeCrossing{i.exit.t, i.exit.t_error, i.exit.face, false};
    }
    return ShapeCrossing{0.0, 0.0, just_left ? just_left->face : nearest_face(tree, ray.origin),
                         false};
  }
  for (const Interval& i : intervals) {
    if (i.enter.t >= 0.0) return ShapeCrossing{i.enter.t, i.enter.t_error, i.enter.face, true};
    if (-i.enter.t <= i.enter.t_error && i.exit.t > -i.enter.t)
      return ShapeCrossing{0.0, i.enter.t_error, i.enter.face, true};
  }
  return std::nullopt;
}

std::optional<ShapeCrossing> next_crossing(const Mesh& mesh, const LocalRay& ray,
                                           const ShapeState& state) {
  const MeshSearch search = !mesh.is_closed() ? MeshSearch::either
                            : state.inside    ? MeshSearch::exit
                                              : MeshSearch::enter;
  const MeshCrossings found =
      first_crossings(mesh, ray, state.touching ? state.face.face : -1, search);
  const Root& enter = found.enter;
  const Root& exit = found.exit;
  if (!mesh.is_closed()) {
    const Root& first = enter.t <= exit.t ? enter : exit;
    if (first.t == kInfinity) return std::nullopt;
    return ShapeCrossing{first.t, first.t_error, first.face, &first == &enter};
  }
  if (!state.inside) {
    if (enter.t == kInfinity) return std::nullopt;
    return ShapeCrossing{enter.t, enter.t_error, enter.face, true};
  }
  // Another part of the solid is entered first, or nothing comes: the way out was missed.
  const bool missed = exit.t == kInfinity ||
                      (enter.t > enter.t_error && enter.t + enter.t_error < exit.t - exit.t_error);
  if (missed) {
    const int face = state.touching ? state.face.face : nearest_face(mesh, ray.origin);
    return ShapeCrossing{0.0, 0.0, {0, face}, false};
  }
  return ShapeCrossing{exit.t, exit.t_error, exit.face, false};
}

} // namespace abbe
