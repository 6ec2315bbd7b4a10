#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace abbe {

using glm::dvec3;

// A mesh with normals of its own reflects and refracts by a normal that is not that of the
// triangle. What goes on may then point to the wrong side of the triangle; it is mirrored at the
// triangle, so that no light is lost and no ray gets to a side where it does not belong.

/// The direction, or its mirror image, on that side of a surface to which the true normal points,
/// or with `above` off on the other one.
[[nodiscard]] inline dvec3 kept_on_side(const dvec3& direction, const dvec3& true_normal,
                                        bool above) {
  const double along = glm::dot(direction, true_normal);
  return (along > 0.0) == above ? direction : direction - 2.0 * along * true_normal;
}

/// The factor on what a light path brings from one direction to another: the ratio of the BSDF for
/// light to that for what the camera sees, which shading normals make differ [Veach97, 5.3]. `to`
/// is the direction before it is mirrored.
[[nodiscard]] inline double adjoint_factor(const dvec3& from, const dvec3& to,
                                           const dvec3& shading_normal, const dvec3& true_normal) {
  const double below = glm::dot(from, true_normal) * glm::dot(to, shading_normal);
  if (below == 0.0) return 0.0;
  return std::abs(glm::dot(from, shading_normal) * glm::dot(to, true_normal) / below);
}

} // namespace abbe
