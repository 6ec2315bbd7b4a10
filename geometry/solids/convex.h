#pragma once

#include "geometry/solids/box.h"
#include "geometry/solids/polyhedron.h"
#include "geometry/solids/sphere.h"
#include "geometry/solids/tapered_cylinder.h"

#include <variant>

namespace abbe {

/// The convex solids: a line meets each in at most one interval. They are the leaves of CSG trees.
using Convex = std::variant<Sphere, Box, ConvexPolyhedron, TaperedCylinder>;

/// True for the types that Convex holds.
template <class S>
concept ConvexSolid = requires(const S& solid, const LocalRay& ray) {
  intersect(solid, ray, static_cast<const FaceContact*>(nullptr)).value().enter;
  nearest_face(solid, ray.origin, ray.direction);
};

} // namespace abbe
