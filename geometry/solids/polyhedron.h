#pragma once

#include "geometry/rays/plane_interval.h"
#include "geometry/rays/transform.h"
#include "geometry/rays/wide.h"

#include <cmath>
#include <optional>
#include <vector>

namespace abbe {

/// The points p with dot(normal, p) <= offset; `normal` has unit length.
struct HalfSpace {
  dvec3 normal{0.0, 0.0, 1.0};
  double offset = 0.0;
};

/// Four half-spaces, for one instruction to work on all. A normal of zero stands for none.
struct FourHalfSpaces {
  Wide x{}, y{}, z{}; ///< of the normals
  Wide offset{};
};

/// A bounded intersection of half-spaces; face i is the plane of half-space i.
class ConvexPolyhedron {
public:
  /// Normals of any length are made unit. Throws std::invalid_argument when the half-spaces
  /// enclose nothing or something unbounded.
  explicit ConvexPolyhedron(std::vector<HalfSpace> half_spaces);

  [[nodiscard]] const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  /// The same, four at a time.
  [[nodiscard]] const std::vector<FourHalfSpaces>& fours() const { return fours_; }
  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }

private:
  std::vector<HalfSpace> half_spaces_;
  std::vector<FourHalfSpaces> fours_;
  std::vector<dvec3> vertices_;
};

/// The thesis's prism [War05, Table 1]: an equilateral triangle in xz with inradius 1 and its
/// apex at z = -2, from y = -1 to y = 1. Faces: top, bottom, front, left, right.
[[nodiscard]] ConvexPolyhedron thesis_prism();

/// Where a line crosses four planes at once, and the nearest of many crossings in each of four
/// lanes.
struct FourPlaneRoots {
  using Faces = std::int64_t __attribute__((vector_size(sizeof(Wide))));

  Wide t;
  Faces face{};

  /// Takes what lies at `other`, in the lanes of the mask.
  void take(const Faces& lanes, const Wide& other, const Faces& others) {
    t = lanes ? other : t;
    face = lanes ? others : face;
  }
  /// The nearest (or with `farthest` the farthest) of the four, of equals the one that was met
  /// first when faces are asked in turn.
  [[nodiscard]] PlaneRoot first(bool farthest) const {
    int best = 0;
    for (int i = 1; i < 4; ++i) {
      const bool better = farthest ? t[i] > t[best] : t[i] < t[best];
      if (better || (t[i] == t[best] && face[i] < face[best])) best = i;
    }
    return {t[best], static_cast<std::int32_t>(face[best])};
  }
};

/// The part of the ray's line inside the solid. With a contact the root of its face is t = 0.
///
/// Each half-space cuts the interval [War05, 4.8.2]: with numer = offset - n.o and denom = n.d the
/// line crosses the plane at numer / denom; it enters where denom < 0 and leaves where denom > 0. A
/// parallel line (denom = 0) is wholly outside where numer < 0 (the thesis prints the two parallel
/// cases the other way round).
[[nodiscard]] std::optional<PlaneInterval> plane_interval(const ConvexPolyhedron& solid,
                                                          const RayInFrame auto& ray,
                                                          const FaceContact* contact) {
  using Faces = FourPlaneRoots::Faces;
  if (contact && contact->side == Side::outside) return std::nullopt; // convex: never met again
  const dvec3 &o = ray.origin, &d = ray.direction;
  const Wide one{1.0, 1.0, 1.0, 1.0};
  FourPlaneRoots enter{-kInfinity * one}, exit{kInfinity * one};
  Faces outside{};
  Faces faces{0, 1, 2, 3};
  const std::int64_t touched = contact ? contact->face : -1;
  for (const FourHalfSpaces& planes : solid.fours()) {
    const Wide denom = planes.x * d.x + planes.y * d.y + planes.z * d.z;
    const Wide numer = planes.offset - (planes.x * o.x + planes.y * o.y + planes.z * o.z);
    const Wide t = numer / (denom != 0.0 ? denom : one);
    exit.take((denom > 0.0) & (t < exit.t) & (faces != touched), t, faces);
    if (!contact) {
      enter.take((denom < 0.0) & (t > enter.t), t, faces);
      outside |= (denom == 0.0) & (numer < 0.0);
    }
    faces += 4;
  }
  // A ray that is known to be inside only leaves: no face begins or empties its interval.
  if (contact) return PlaneInterval{{0.0, contact->face}, exit.first(false)};
  if ((outside[0] | outside[1] | outside[2] | outside[3]) != 0) return std::nullopt;
  const PlaneInterval inside{enter.first(true), exit.first(false)};
  if (inside.enter.t > inside.exit.t) return std::nullopt;
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
