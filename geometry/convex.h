#pragma once

#include "geometry/box.h"
#include "geometry/polyhedron.h"
#include "geometry/sphere.h"
#include "geometry/tapered_cylinder.h"

#include <variant>

namespace abbe {

/// The convex solids: a line meets each in at most one interval. They are the leaves of CSG trees.
using Convex = std::variant<Sphere, Box, ConvexPolyhedron, TaperedCylinder>;

/// True for the types that Convex holds.
template <class S>
concept ConvexSolid = requires(const S& solid, const LocalRay& ray) {
  intersect(solid, ray, static_cast<const FaceContact*>(nullptr)).value().enter;
  nearest_face(solid, ray.origin);
};

} // namespace abbe
