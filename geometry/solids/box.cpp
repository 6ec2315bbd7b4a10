#include "geometry/solids/box.h"

#include <algorithm>
#include <cmath>

namespace abbe {

std::optional<Interval> intersect(const Box& box, const LocalRay& ray, const FaceContact* contact) {
  return with_errors(box, ray, contact);
}

dvec3 outward_normal(const Box&, const dvec3&, int face) {
  dvec3 n(0.0);
  n[face / 2] = face % 2 ? 1.0 : -1.0;
  return n;
}

int nearest_face(const Box&, const dvec3& point) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(point[i]) > std::abs(point[axis])) axis = i;
  return 2 * axis + (point[axis] > 0.0 ? 1 : 0);
}

double signed_distance(const Box&, const dvec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) - 1.0;
}

Bounds bounds(const Box&, const Transform& to_world) {
  return to_world.box({dvec3(-1.0), dvec3(1.0)});
}

} // namespace abbe
