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
  const int touched = state.touching ? state.face.face : -1;
  if (!mesh.is_closed()) {
    const MeshCrossings found = first_crossings(mesh, ray, touched, MeshSearch::either);
    const Root& first = found.enter.t <= found.exit.t ? found.enter : found.exit;
    if (first.t == kInfinity) return std::nullopt;
    return ShapeCrossing{first.t, first.t_error, first.face, &first == &found.enter};
  }
  const MeshCrossings found =
      first_crossings(mesh, ray, touched, state.inside ? MeshSearch::exit : MeshSearch::enter);
  const Root& wanted = state.inside ? found.exit : found.enter;
  const Root& other = state.inside ? found.enter : found.exit;
  // Where a ray starts at an edge, rounding may put its line beside the triangle through which it
  // should go at once. Then the next crossing is of the other kind, or no way leads out. If the two
  // cannot be told apart, all crossings ahead decide.
  const bool missed = [&] {
    if (other.t == kInfinity) return state.inside && wanted.t == kInfinity;
    if (other.t + other.t_error < wanted.t - wanted.t_error) return true;
    if (wanted.t + wanted.t_error < other.t - other.t_error) return false;
    const MeshCrossings all = first_crossings(mesh, ray, touched, MeshSearch::sum);
    return (all.exits_less_entries > 0) != state.inside;
  }();
  if (missed)
    return ShapeCrossing{0.0, 0.0, {0, nearest_face(mesh, ray, !state.inside)}, !state.inside};
  if (wanted.t == kInfinity) return std::nullopt;
  return ShapeCrossing{wanted.t, wanted.t_error, wanted.face, !state.inside};
}

} // namespace abbe
