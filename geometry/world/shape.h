#pragma once

#include "geometry/booleans/csg.h"
#include "geometry/meshes/mesh.h"
#include "geometry/solids/flat.h"

#include <optional>
#include <span>
#include <type_traits>
#include <variant>

namespace abbe {

/// Every kind of shape that a scene may hold.
using Shape = std::variant<Sphere, Box, ConvexPolyhedron, TaperedCylinder, CsgTree, Mesh, Square,
                           Disc, Plane>;

/// A shape at its place, with what a ray must know when it meets it.
struct PlacedShape {
  Shape shape;
  Transform to_world;
  MaterialId material; ///< of its surface
  MediumId medium;     ///< what fills it; invalid: nothing passes (opaque), or it has no inside
  int priority = 0;    ///< where solids overlap, the medium of the highest priority is there
  /// A surface without inside that light passes straight through. Where it coincides with another
  /// one, that shows: what lies behind it would not be met otherwise.
  bool gives_way = false;
};

/// True when the shape has an inside.
[[nodiscard]] bool is_solid(const Shape& shape);
/// True for a mesh that is shaded by normals at its corners.
[[nodiscard]] bool is_smooth(const Shape& shape);
/// False for a shape without end, whose bounds say nothing.
[[nodiscard]] bool is_bounded(const Shape& shape);
/// True when the world point lies inside the solid.
[[nodiscard]] bool contains(const PlacedShape& placed, const dvec3& world_point);
[[nodiscard]] Bounds bounds(const PlacedShape& placed);

// Shapes that are no tree have one leaf, number 0.
template <class S>
  requires(!std::is_same_v<S, CsgTree>)
[[nodiscard]] dvec3 outward_normal(const S& shape, const dvec3& point, FaceId face) {
  return outward_normal(shape, point, face.face);
}
template <class S>
  requires(!std::is_same_v<S, CsgTree>)
[[nodiscard]] dvec3 snapped(const S& shape, const dvec3& point, FaceId face) {
  return snapped(shape, point, face.face);
}

/// Where a ray next crosses a shape's boundary.
struct ShapeCrossing {
  double t = 0.0;
  double t_error = 0.0;
  FaceId face;
  bool entering = false; ///< from outside to inside; of a flat shape: against its normal

  /// Sets the members one by one. A later copy of a struct that was assigned as a whole would wait
  /// for its values to reach the cache.
  void set(double at, double error, FaceId on, bool enters) {
    t = at;
    t_error = error;
    face = on;
    entering = enters;
  }
};

/// A face on which a ray's origin lies, and whether the ray runs inside the solid from there.
struct TouchedFace {
  FaceId face;
  bool inside = false;
};

/// What a ray already knows about a shape: whether it is inside, and whether its origin lies on
/// one of the faces (`face`), on the solid's side that `inside` tells. Where the ray has crossed
/// other faces at the same place before, as at a corner, these are `others`; only trees and meshes
/// need them, since a ray crosses a convex solid once.
struct ShapeState {
  bool inside = false;
  bool touching = false;
  FaceId face;
  std::span<const TouchedFace> others = {};
};

// Finds the next crossing, see `next_crossing`, unless it lies at `farthest` or beyond. For the
// innermost loops: the result is written into the caller's variable.
template <FlatShape S>
[[nodiscard]] bool find_next(const S& shape, const RayInFrame auto& ray, const ShapeState& state,
                             double farthest, ShapeCrossing& next) {
  if (state.touching) return false; // never met again
  const auto root = intersect(shape, ray, 0.0, farthest);
  if (!root) return false;
  next.set(root->t, root->t_error, root->face, ray.direction.z < 0.0);
  return true;
}
template <ConvexSolid S>
[[nodiscard]] bool find_next(const S& solid, const RayInFrame auto& ray, const ShapeState& state,
                             double farthest, ShapeCrossing& next) {
  if (state.touching && !state.inside) return false; // convex: never met again
  const FaceContact touched{state.face.face, Side::inside};
  const FaceContact* contact = state.touching ? &touched : nullptr;
  const auto inside = [&] {
    if constexpr (PlaneFaced<S>)
      return plane_interval(solid, ray, contact);
    else
      return intersect(solid, ray, contact);
  }();
  const auto error = [&](const auto& root) {
    if constexpr (PlaneFaced<S>)
      return root_error(solid, ray, root);
    else
      return root.t_error;
  };
  const auto face = [](const auto& root) {
    if constexpr (PlaneFaced<S>)
      return FaceId{0, root.face};
    else
      return root.face;
  };
  if (state.inside) {
    // The exit is endless only for a ray that runs out through the face it should run in from.
    if (!inside || inside->exit.t == kInfinity) {
      next.set(0.0, 0.0, {0, nearest_face(solid, ray.origin, ray.direction)}, false);
      return true;
    }
    const auto& exit = inside->exit;
    next.set(exit.t > 0.0 ? exit.t : 0.0, error(exit), face(exit), false);
    return true;
  }
  if (!inside || inside->exit.t < 0.0 || inside->enter.t >= farthest) return false;
  const auto& enter = inside->enter;
  const double enter_error = error(enter);
  // Behind the origin by no more than rounding, with the solid ahead: it is entered here.
  if (enter.t < 0.0 && !(-enter.t <= enter_error && inside->exit.t > -enter.t)) return false;
  next.set(enter.t >= 0.0 ? enter.t : 0.0, enter_error, face(enter), true);
  return true;
}

// The next crossing of one shape, t >= 0. A ray known to be inside always finds an exit: where
// rounding leaves none, the exit is at t = 0 through the nearest face that it does not run in from.
// A ray known to be outside only enters; a mesh at t = 0 where its crossings ahead show that
// rounding has let the ray slip in. The root of the touched face is never computed.
[[nodiscard]] std::optional<ShapeCrossing> next_crossing(const CsgTree& tree, const LocalRay& ray,
                                                         const ShapeState& state);
[[nodiscard]] std::optional<ShapeCrossing> next_crossing(const Mesh& mesh, const LocalRay& ray,
                                                         const ShapeState& state);
template <class S>
  requires FlatShape<S> || ConvexSolid<S>
[[nodiscard]] std::optional<ShapeCrossing> next_crossing(const S& shape, const LocalRay& ray,
                                                         const ShapeState& state) {
  ShapeCrossing next;
  return find_next(shape, ray, state, kInfinity, next) ? std::optional(next) : std::nullopt;
}

} // namespace abbe
