#pragma once

#include "tests/stress/furnace/random_scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace abbe::stress {

/// The reference's numbers: it shares no code with geometry/ and has a precision of its own.
using Real = long double;
using Vector = glm::vec<3, long double, glm::defaultp>;

struct Line {
  Vector origin, direction;
  [[nodiscard]] Vector at(Real t) const { return origin + t * direction; }
};

/// Where a line crosses the surface of a solid.
struct SurfaceCrossing {
  Real t;
  Vector normal; ///< unit, outward
};

/// All crossings of the whole line, sorted. Of a solid they are entries and exits in turn: there is
/// no state that a ray takes along, a place is inside when an odd number of crossings lies before
/// it. Of a flat shape there is one at most.
[[nodiscard]] std::vector<SurfaceCrossing> crossings(const Solid& solid, const Line& line);

} // namespace abbe::stress
