#pragma once

#include "geometry/world/shape.h"

#include <glm/vec2.hpp>

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace abbe {

using glm::dvec2;

/// A point of a surface, chosen to be seen from a place.
struct SeenPoint {
  dvec3 direction{0.0};  ///< unit, from the place
  double distance = 0.0; ///< not beyond the surface
  double pdf = 0.0;      ///< of the choice, per steradian about the place
};

/// A point of a surface, chosen regardless of who sees it.
struct SurfacePoint {
  dvec3 point{0.0};
  dvec3 normal{0.0}; ///< unit, outwards
  FaceId face;
  double pdf = 0.0; ///< of the choice, per unit of world area
};

/// A triangle by a corner and the edges that leave it.
struct TriangleEdges {
  dvec3 corner, ab, ac;
};

// Surfaces in the world, with what does not depend on the place that looks at them computed once.
// Each has the same four functions:
//   sample   a point for two numbers in [0, 1); nothing where the one chosen shows its dark side
//   pdf      per steradian, with which `sample` would have chosen a point that a ray from `place`
//            meets on a side that counts, where the outward unit normal is `normal`
//   area     of the surface
//   at       a point of the whole surface for two numbers in [0, 1), wherever it is seen from

/// A square or disc: uniform in area.
struct FlatSurface {
  dvec3 origin, x, y; ///< a corner and two edges, or the centre and two half-axes
  dvec3 normal;
  double size; ///< its area
  bool disc, both_sides;

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  [[nodiscard]] double area() const { return size; }
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
};

/// A sphere under a similarity: uniform in the cone that it fills.
struct BallSurface {
  dvec3 centre;
  double radius;

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  [[nodiscard]] double area() const;
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
};

/// A sphere under any other map: uniform in area before the map.
struct EllipsoidSurface {
  Transform to_world;
  double volume_scale; ///< of the map

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  /// By a rule of 48 x 48 points.
  [[nodiscard]] double area() const;
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
  [[nodiscard]] double area_pdf(const dvec3& normal) const;
};

/// A box: uniform in area on those of its faces, three at most, that turn to the place.
struct BoxSurface {
  dvec3 centre;
  std::array<dvec3, 3> half, normal; ///< half an edge; outwards where it ends
  std::array<double, 3> height;      ///< from the centre to the face
  std::array<double, 3> face_area;

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  [[nodiscard]] double area() const;
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
  /// Of each pair of faces 1 or -1 for the one that turns to the place, 0 for none.
  [[nodiscard]] std::array<int, 3> seen(const dvec3& place) const;
  [[nodiscard]] double seen_area(const std::array<int, 3>& sides) const;
};

/// A convex polyhedron: uniform in area on those of its faces that turn to the place.
struct PolyhedronSurface {
  struct Part { ///< of a face
    TriangleEdges triangle;
    dvec3 normal;
    double area;
    int face;
  };
  std::vector<Part> parts;
  double whole_area;

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  [[nodiscard]] double area() const { return whole_area; }
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
  [[nodiscard]] double seen_area(const dvec3& place) const;
};

/// A mesh: uniform in area over all triangles. The mesh itself is not copied.
struct MeshSurface {
  const Mesh* mesh;
  Transform to_world;
  std::vector<double> cumulative; ///< areas in the world
  bool mirrored, both_sides;

  [[nodiscard]] std::optional<SeenPoint> sample(const dvec3& place, const dvec2& u) const;
  [[nodiscard]] double pdf(const dvec3& place, const dvec3& point, const dvec3& normal) const;
  [[nodiscard]] double area() const { return cumulative.back(); }
  [[nodiscard]] SurfacePoint at(const dvec2& u) const;
  [[nodiscard]] TriangleEdges triangle(int i) const;
  /// The outward unit normal.
  [[nodiscard]] dvec3 normal(const TriangleEdges& triangle) const;
  /// Chooses a triangle in proportion to its area; `u` becomes a number in [0, 1) again.
  [[nodiscard]] int choose(double& u) const;
};

using SampledSurface = std::variant<FlatSurface, BallSurface, EllipsoidSurface, BoxSurface,
                                    PolyhedronSurface, MeshSurface>;

/// The surface of a square, disc, sphere, box, convex polyhedron or mesh; nothing for other shapes,
/// which cannot be sampled. `both_sides`: those of a shape that is no solid; of solids only the
/// outside counts.
[[nodiscard]] std::optional<SampledSurface> sampled_surface(const PlacedShape& placed,
                                                            bool both_sides);

/// The point of a triangle for two numbers in [0, 1), uniform in area: the square root turns the
/// unit square into a triangle [Turk90].
[[nodiscard]] dvec3 triangle_point(const TriangleEdges& triangle, double u, double v);

/// The point of the unit sphere for two numbers in [0, 1), uniform in area, which is proportional
/// to height [Archimedes].
[[nodiscard]] dvec3 sphere_point(const dvec2& u);

/// True when a shape has a surface that can be sampled.
[[nodiscard]] bool can_sample_surface(const Shape& shape);

} // namespace abbe
