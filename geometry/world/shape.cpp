#include "geometry/world/shape.h"

#include "geometry/rays/short_vector.h"

#include <cmath>

namespace abbe {

bool is_solid(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->is_closed();
  return std::visit([]<class S>(const S&) { return !FlatShape<S>; }, shape);
}

bool is_smooth(const Shape& shape) {
  const auto* mesh = std::get_if<Mesh>(&shape);
  return mesh && mesh->corner_normals();
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
  const auto contact_on = [&](const FaceId& face, bool inside) -> CsgContact {
    const bool flipped = tree.leaves()[static_cast<std::size_t>(face.leaf)].flipped;
    return {face.leaf, {face.face, inside != flipped ? Side::inside : Side::outside}};
  };
  thread_local std::vector<Interval> intervals;
  intervals.clear();
  if (!state.others.empty()) [[unlikely]] {
    ShortVector<CsgContact, 8> contacts;
    if (state.touching) contacts.push_back(contact_on(state.face, state.inside));
    for (const TouchedFace& other : state.others)
      contacts.push_back(contact_on(other.face, other.inside));
    intersect(tree, ray, {contacts.begin(), contacts.size()}, intervals);
  } else if (state.touching) {
    const CsgContact contact = contact_on(state.face, state.inside);
    intersect(tree, ray, {&contact, 1}, intervals);
  } else {
    intersect(tree, ray, {}, intervals);
  }

  if (state.inside) {
    const Root* just_left = nullptr; // an exit that rounding has put behind the origin
    const Interval* later = nullptr; // a later part of the solid
    for (const Interval& i : intervals) {
      if (i.exit.t < 0.0) {
        if (-i.exit.t <= i.exit.t_error) just_left = &i.exit;
        continue;
      }
      if (i.enter.t > i.enter.t_error) {
        later = &i;
        break;
      }
      return ShapeCrossing{i.exit.t, i.exit.t_error, i.exit.face, false};
    }
    if (just_left) return ShapeCrossing{0.0, 0.0, just_left->face, false};
    // The origin is off its place, as the ray that led there was: at an edge it may lie in front of
    // another face than the one that was met, by which the ray enters, or behind one, by which it
    // leaves. It is the one that it is less far from.
    const WayOut out = nearest_way_out(tree, ray.origin, ray.direction);
    if (later && later->enter.t * glm::length(ray.direction) < out.move)
      return ShapeCrossing{later->exit.t, later->exit.t_error, later->exit.face, false};
    return ShapeCrossing{0.0, 0.0, out.face, false};
  }
  for (const Interval& i : intervals) {
    if (i.enter.t >= 0.0) return ShapeCrossing{i.enter.t, i.enter.t_error, i.enter.face, true};
    if (-i.enter.t <= i.enter.t_error && i.exit.t > -i.enter.t)
      return ShapeCrossing{0.0, i.enter.t_error, i.enter.face, true};
    // A ray from an edge goes into the solid through another face than the one it is known to lie
    // on: both are crossed at once, and the solid goes on in front and behind. Or its origin is
    // behind a face by which it has left, if that one is nearer.
    if (state.touching && i.enter.t < 0.0 && i.exit.t > i.exit.t_error) {
      const WayOut in = nearest_way_out(tree, ray.origin, -ray.direction);
      if (in.move <= i.exit.t * glm::length(ray.direction))
        return ShapeCrossing{0.0, 0.0, in.face, true};
    }
  }
  return std::nullopt;
}

namespace {

/// What lies ahead of a ray that is inside a closed mesh, or outside.
struct MeshAhead {
  MeshCrossings found;
  bool missed = false; ///< it is not as the crossings would have it
};

/// Where a ray starts at an edge, rounding may put its line beside the triangle through which it
/// should go at once. Then the next crossing is of the other kind, or there is no exit. If the two
/// cannot be told apart, all crossings ahead decide.
MeshAhead look_ahead(const Mesh& mesh, const LocalRay& ray, std::span<const std::int32_t> touched,
                     bool inside) {
  const MeshCrossings found =
      first_crossings(mesh, ray, touched, inside ? MeshSearch::exit : MeshSearch::enter);
  const Root& wanted = inside ? found.exit : found.enter;
  const Root& other = inside ? found.enter : found.exit;
  const bool missed = [&] {
    if (other.t == kInfinity) return inside && wanted.t == kInfinity;
    if (other.t + other.t_error < wanted.t - wanted.t_error) return true;
    if (wanted.t + wanted.t_error < other.t - other.t_error) return false;
    const MeshCrossings all = first_crossings(mesh, ray, touched, MeshSearch::sum);
    return (all.exits_less_entries > 0) != inside;
  }();
  return {found, missed};
}

/// True where a ray inside comes to a wall at which one body of the mesh ends and another begins:
/// it leaves and enters at places that rounding cannot tell apart.
bool meets_wall(const MeshAhead& ahead) {
  const Root& exit = ahead.found.exit;
  const Root& enter = ahead.found.enter;
  if (ahead.missed || exit.t == kInfinity || enter.t == kInfinity) return false;
  return std::abs(enter.t - exit.t) <= enter.t_error + exit.t_error;
}

} // namespace

std::optional<ShapeCrossing> next_crossing(const Mesh& mesh, const LocalRay& ray,
                                           const ShapeState& state) {
  ShortVector<std::int32_t, 8> touched;
  if (state.touching) touched.push_back(state.face.face);
  for (const TouchedFace& other : state.others)
    touched.push_back(other.face.face);
  std::span<const std::int32_t> touched_faces(touched.begin(), touched.size());
  if (!mesh.is_closed()) {
    const MeshCrossings found = first_crossings(mesh, ray, touched_faces, MeshSearch::either);
    const Root& first = found.enter.t <= found.exit.t ? found.enter : found.exit;
    if (first.t == kInfinity) return std::nullopt;
    return ShapeCrossing{first.t, first.t_error, first.face, &first == &found.enter};
  }
  MeshAhead ahead = look_ahead(mesh, ray, touched_faces, state.inside);
  // A ray away from the surface has lost no crossing at its start. Its line runs through a vertex
  // so closely that the signs of the edges there contradict each other. A line beside it, no
  // farther off than rounding, tells what is met.
  if (ahead.missed && !state.touching) {
    const double rounding = 4.0 * ray.shift_at(0.0, mesh.size());
    for (int corner = 0; corner < 8 && ahead.missed; ++corner) {
      LocalRay beside = ray;
      beside.coordinate_error += 2.0 * rounding; // by sqrt(3) times as much at most
      for (int axis = 0; axis < 3; ++axis)
        beside.origin[axis] += (corner >> axis & 1) != 0 ? rounding : -rounding;
      ahead = look_ahead(mesh, beside, touched_faces, state.inside);
    }
  }
  while (state.inside && meets_wall(ahead)) [[unlikely]] {
    touched.push_back(ahead.found.exit.face.face);
    touched.push_back(ahead.found.enter.face.face);
    touched_faces = {touched.begin(), touched.size()};
    ahead = look_ahead(mesh, ray, touched_faces, true);
  }
  // A ray that has left along a face may seem to enter by it where it is. It does when more exits
  // than entries lie ahead.
  while (!state.inside && state.touching && !ahead.missed &&
         ahead.found.enter.t <= ahead.found.enter.t_error) [[unlikely]] {
    if (first_crossings(mesh, ray, touched_faces, MeshSearch::sum).exits_less_entries > 0) break;
    touched.push_back(ahead.found.enter.face.face);
    touched_faces = {touched.begin(), touched.size()};
    ahead = look_ahead(mesh, ray, touched_faces, false);
  }
  const Root& wanted = state.inside ? ahead.found.exit : ahead.found.enter;
  if (ahead.missed && (state.touching || state.inside)) {
    // Either the ray crosses at once, or its origin is off its place, as the ray that led there
    // was: at an edge it may lie beyond another face than the one that was met, which then is
    // crossed first; and a ray along a face may cross that. It is what takes the smallest move.
    const Root& other = state.inside ? ahead.found.enter : ahead.found.exit;
    NearFace at_once = nearest_face(mesh, ray, !state.inside);
    if (state.touching) {
      const double depth = depth_below(mesh, ray, state.face.face);
      if (depth < at_once.distance) at_once = {state.face.face, depth};
    }
    const bool beyond = other.t != kInfinity && (!state.inside || wanted.t != kInfinity) &&
                        other.t * glm::length(ray.direction) < at_once.distance;
    if (!beyond) return ShapeCrossing{0.0, 0.0, {0, at_once.face}, !state.inside};
  }
  if (wanted.t == kInfinity) return std::nullopt;
  return ShapeCrossing{wanted.t, wanted.t_error, wanted.face, !state.inside};
}

} // namespace abbe
