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

int nearest_face(const Box&, const dvec3& point, const dvec3& direction) {
  int nearest = 0;
  double highest = -kInfinity;
  for (int face = 0; face < 6; ++face) {
    const double sign = face % 2 ? 1.0 : -1.0, height = sign * point[face / 2];
    if (sign * direction[face / 2] < 0.0 || height <= highest) continue;
    highest = height;
    nearest = face;
  }
  return nearest;
}

double signed_distance(const Box&, const dvec3& point) {
  return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) - 1.0;
}

Bounds bounds(const Box&, const Transform& to_world) {
  return to_world.box({dvec3(-1.0), dvec3(1.0)});
}

} // namespace abbe
