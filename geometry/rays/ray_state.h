#pragma once

#include "geometry/rays/interval.h"
#include "geometry/rays/ray.h"
#include "geometry/rays/short_vector.h"

namespace abbe {

/// A surface on which a ray's origin lies, and the side of the shape to which the ray goes. The
/// outside of a flat shape is where its normal points.
struct SurfaceContact {
  ShapeId shape;
  FaceId face;
  Side side = Side::outside;
  friend bool operator==(const SurfaceContact&, const SurfaceContact&) = default;
};

/// All surfaces that meet at a ray's origin: one as a rule, more where solids touch. The first is
/// the one that shows, and its side always holds. The sides of the others hold unless the ray's
/// direction contradicts them: a ray in a corner of two walls crosses the second one at once.
using Contacts = ShortVector<SurfaceContact, 4>;

/// The solids that contain a ray's origin, in the order in which they were entered.
using Nesting = ShortVector<ShapeId, 8>;

/// A ray, with the surfaces that its origin lies on and the solids that it is inside of. Solvers go
/// by these identities, where a tolerance would guess.
struct RayState {
  Ray ray; ///< in world coordinates; `direction` has unit length
  Contacts contacts;
  Nesting nesting;
};

/// What a ray meets next, if anything.
struct Hit {
  Hit() {} // not `= default`: value-initialization would clear the lists' storage first

  [[nodiscard]] bool met() const { return shape.valid(); }

  double t = 0.0;    ///< distance from the ray's origin
  dvec3 point{0.0};  ///< on the surface
  dvec3 normal{0.0}; ///< unit, outwards from the shape
  /// What light is reflected and refracted by: `normal`, but on a mesh with normals of its own,
  /// where the ray runs through both in the same sense.
  dvec3 shading_normal{0.0};
  ShapeId shape;        ///< the shape that shows
  FaceId face;          ///< the part of the shape that shows
  bool entering = true; ///< the ray runs against `normal` and `shading_normal`
  bool moved = true;    ///< false: rounding cannot tell the point from the ray's origin
  MaterialId material;  ///< the material of that part
  MediumId medium_before, medium_after;
  /// True where the surface is shaded by another normal than its own.
  [[nodiscard]] bool bent() const { return shading_normal != normal; }
  /// The two normals, against the ray.
  [[nodiscard]] dvec3 facing_normal() const { return entering ? normal : -normal; }
  [[nodiscard]] dvec3 facing_shading_normal() const {
    return entering ? shading_normal : -shading_normal;
  }

  // A ray that leaves on the side it came from takes same_side and nesting_before (not the nesting
  // it came with: it may have passed boundaries that do not show); one that goes through takes
  // other_side and nesting_after.
  Contacts same_side, other_side;
  Nesting nesting_before, nesting_after;
};

} // namespace abbe
