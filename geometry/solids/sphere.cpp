#include "geometry/solids/sphere.h"

#include <algorithm>
#include <cmath>

namespace abbe {
int nearest_face(const Sphere&, const dvec3&, const dvec3&) {
  return 0;
}

double signed_distance(const Sphere&, const dvec3& point) {
  return glm::length(point) - 1.0;
}

Bounds bounds(const Sphere&, const Transform& to_world) {
  return to_world.unit_sphere_box();
}

} // namespace abbe
