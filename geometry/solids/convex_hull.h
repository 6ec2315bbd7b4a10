#pragma once

#include "geometry/solids/polyhedron.h"

#include <vector>

namespace abbe {

/// The half-spaces of the faces of the points' convex hull, each face once. Points inside it, and
/// on its faces and edges, change nothing. Each three points are tried: meant for some hundred.
/// Throws std::invalid_argument when the points lie in one plane.
[[nodiscard]] std::vector<HalfSpace> hull_planes(const std::vector<dvec3>& points);

} // namespace abbe
