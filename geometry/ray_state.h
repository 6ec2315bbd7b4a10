#pragma once

#include "geometry/fixed_vector.h"
#include "geometry/interval.h"
#include "geometry/ray.h"

namespace abbe {

/// A surface on which a ray's origin lies, and the side of the shape to which the ray goes.
struct SurfaceContact {
  ShapeId shape;
  FaceId face;
  Side side = Side::outside;
};

/// All surfaces that meet at a ray's origin: one as a rule, more where solids touch.
using Contacts = FixedVector<SurfaceContact, 4>;

/// The solids that contain a ray's origin, in the order in which they were entered.
using Nesting = FixedVector<ShapeId, 8>;

/// The record of a ray: what identity and side say, and no tolerance can.
struct RayState {
  Ray ray; ///< in world coordinates; `direction` has unit length
  Contacts contacts;
  Nesting nesting;
};

/// What a ray meets next.
struct Hit {
  double t = 0.0;       ///< distance from the ray's origin
  dvec3 point{0.0};     ///< on the surface
  dvec3 normal{0.0};    ///< unit, outwards from the shape
  ShapeId shape;        ///< the shape that shows
  FaceId face;          ///< and which part of it
  bool entering = true; ///< the ray runs against `normal`
  MaterialId material;  ///< the finish of that part
  MediumId medium_before, medium_after;
  Contacts same_side;    ///< for rays that leave on the side they came from
  Contacts other_side;   ///< for rays that go through
  Nesting nesting_after; ///< for rays that go through
};

} // namespace abbe
