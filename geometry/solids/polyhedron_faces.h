#pragma once

#include "geometry/solids/polyhedron.h"

#include <vector>

namespace abbe {

/// The corners of a face in their order around it, counter-clockwise as seen from outside; none
/// where its plane holds no part of the surface, or is that of an earlier face.
[[nodiscard]] std::vector<dvec3> face_corners(const ConvexPolyhedron& solid, int face);

} // namespace abbe
