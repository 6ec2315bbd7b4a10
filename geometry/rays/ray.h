#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace abbe {

using glm::dvec3;

/// A half-line in double precision. `direction` need not have unit length: a parameter t found in
/// a shape's own frame is then the same t in the world.
struct Ray {
  dvec3 origin{0.0};
  dvec3 direction{0.0, 0.0, 1.0};

  [[nodiscard]] dvec3 at(double t) const { return origin + t * direction; }
};

} // namespace abbe
