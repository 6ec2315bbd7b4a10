#pragma once

#include "geometry/rays/plane_interval.h"
#include "geometry/rays/transform.h"

#include <cmath>
#include <optional>
#include <vector>

namespace abbe {

/// The points p with dot(normal, p) <= offset; `normal` has unit length.
struct HalfSpace {
  dvec3 normal{0.0, 0.0, 1.0};
  double offset = 0.0;
};

/// Cuts the candidate interval with one half-space [War05, 4.8.2]: with numer = offset - n.o and
/// denom = n.d the line crosses the plane at numer / denom; it enters where denom < 0 and leaves
/// where denom > 0. A parallel line (denom = 0) is wholly outside where numer < 0 (the thesis
/// prints the two parallel cases the other way round). Returns false when nothing remains.
[[nodiscard]] bool narrow(PlaneInterval& candidate, const HalfSpace& half_space, int face,
                          const RayInFrame auto& ray) {
  const double denom = glm::dot(half_space.normal, ray.direction);
  const double numer = half_space.offset - glm::dot(half_space.normal, ray.origin);
  if (denom == 0.0) return numer >= 0.0;
  const double t = numer / denom;
  if (denom < 0.0 && t > candidate.enter.t) candidate.enter = {t, face};
  if (denom > 0.0 && t < candidate.exit.t) candidate.exit = {t, face};
  return candidate.enter.t <= candidate.exit.t;
}

/// A bounded intersection of half-spaces; face i is the plane of half-space i.
class ConvexPolyhedron {
public:
  /// Normals of any length are made unit. Throws std::invalid_argument when the half-spaces
  /// enclose nothing or something unbounded.
  explicit ConvexPolyhedron(std::vector<HalfSpace> half_spaces);

  [[nodiscard]] const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }

private:
  std::vector<HalfSpace> half_spaces_;
  std::vector<dvec3> vertices_;
};

/// The thesis's prism [War05, Table 1]: an equilateral triangle in xz with inradius 1 and its
/// apex at z = -2, from y = -1 to y = 1. Faces: top, bottom, front, left, right.
[[nodiscard]] ConvexPolyhedron thesis_prism();

/// The part of the ray's line inside the solid. With a contact the root of its face is t = 0.
[[nodiscard]] std::optional<PlaneInterval> plane_interval(const ConvexPolyhedron& solid,
                                                          const RayInFrame auto& ray,
                                                          const FaceContact* contact) {
  const std::vector<HalfSpace>& planes = solid.half_spaces();
  const int count = static_cast<int>(planes.size());
  PlaneInterval inside;
  if (!contact) {
    for (int i = 0; i < count; ++i)
      if (!narrow(inside, planes[static_cast<std::size_t>(i)], i, ray)) return std::nullopt;
    return inside;
  }
  if (contact->side == Side::outside) return std::nullopt; // convex: never met again
  // Known to be inside: every other face can only end the interval, never begin or empty it.
  for (int i = 0; i < count; ++i) {
    if (i == contact->face) continue;
    const HalfSpace& plane = planes[static_cast<std::size_t>(i)];
    const double denom = glm::dot(plane.normal, ray.direction);
    if (denom <= 0.0) continue;
    const double t = (plane.offset - glm::dot(plane.normal, ray.origin)) / denom;
    if (t < inside.exit.t) inside.exit = {t, i};
  }
  inside.enter = {0.0, contact->face};
  return inside;
}
/// The bound of a root's error.
[[nodiscard]] double root_error(const ConvexPolyhedron& solid, const RayInFrame auto& ray,
                                const PlaneRoot& root) {
  if (std::isinf(root.t)) return 0.0; // an open end
  const HalfSpace& plane = solid.half_spaces()[static_cast<std::size_t>(root.face)];
  const double speed = std::abs(glm::dot(plane.normal, ray.direction));
  return plane_root_error(ray, speed, root.t, std::abs(plane.offset));
}
[[nodiscard]] std::optional<Interval> intersect(const ConvexPolyhedron& solid, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const ConvexPolyhedron& solid, const dvec3& point, int face);
[[nodiscard]] inline dvec3 snapped(const ConvexPolyhedron& solid, const dvec3& point, int face) {
  const HalfSpace& h = solid.half_spaces()[static_cast<std::size_t>(face)];
  return point - (glm::dot(h.normal, point) - h.offset) * h.normal;
}
/// The nearest of the faces that a ray in this direction does not run in from.
[[nodiscard]] int nearest_face(const ConvexPolyhedron& solid, const dvec3& point,
                               const dvec3& direction);
[[nodiscard]] double signed_distance(const ConvexPolyhedron& solid, const dvec3& point);
[[nodiscard]] Bounds bounds(const ConvexPolyhedron& solid, const Transform& to_world);

} // namespace abbe
