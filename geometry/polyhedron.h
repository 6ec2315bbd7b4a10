#pragma once

#include "geometry/interval.h"
#include "geometry/local_ray.h"
#include "geometry/transform.h"

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
bool narrow(Interval& candidate, const HalfSpace& half_space, int face, const LocalRay& ray);

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

[[nodiscard]] std::optional<Interval> intersect(const ConvexPolyhedron& solid, const LocalRay& ray,
                                                const FaceContact* contact = nullptr);
[[nodiscard]] dvec3 outward_normal(const ConvexPolyhedron& solid, const dvec3& point, int face);
[[nodiscard]] dvec3 snapped(const ConvexPolyhedron& solid, const dvec3& point, int face);
[[nodiscard]] int nearest_face(const ConvexPolyhedron& solid, const dvec3& point);
[[nodiscard]] double signed_distance(const ConvexPolyhedron& solid, const dvec3& point);
[[nodiscard]] Bounds bounds(const ConvexPolyhedron& solid, const Transform& to_world);

} // namespace abbe
