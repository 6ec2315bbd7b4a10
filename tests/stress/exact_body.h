#pragma once

#include "geometry/world/shape.h"

#include <glm/mat3x3.hpp>

#include <array>
#include <vector>

// What the rays of the stress suite are compared with: the same shapes in 80-bit arithmetic, by
// formulas of their own. No contact is known, no interval list is merged, no bound of rounding is
// used to decide; where a point lies is asked point by point.
namespace abbe::stress {

using Real = long double;
using Vec = glm::vec<3, Real>;
using Mat = glm::mat<3, 3, Real>;

struct ExactCrossing {
  Real t = 0;
  bool entering = false;
  FaceId face;
};

/// A convex solid, or the plane of a flat shape, in a frame of its own.
struct ExactLeaf {
  enum class Kind : std::uint8_t { ball, planes, taper, square, disc, endless };

  ExactLeaf(Kind form, const Transform& to_world);

  [[nodiscard]] bool contains(const Vec& world) const;
  /// The stretch of a line inside; `first.t > last.t` where there is none.
  void stretch(const Vec& origin, const Vec& direction, ExactCrossing& first,
               ExactCrossing& last) const;
  [[nodiscard]] int faces() const;
  /// How far a point is outside the surface of one face in the world, to first order; negative
  /// inside.
  [[nodiscard]] Real height(int face, const Vec& world) const;
  /// Whether a place on a face can be seen on the solid when its other faces are moved by `moved`.
  [[nodiscard]] bool may_show(int face, const Vec& world, Real moved) const;
  /// The magnitude of `height`.
  [[nodiscard]] Real distance(int face, const Vec& world) const;
  /// The smallest of all faces.
  [[nodiscard]] Real clearance(const Vec& world) const;
  [[nodiscard]] Vec normal(int face, const Vec& world) const;
  /// By how much a normal turns at most where the place moves by `shift`.
  [[nodiscard]] Real turn(int face, const Vec& world, Real shift) const;
  [[nodiscard]] Vec seen(const Vec& world) const { return inverse * (world - offset); }

  Kind kind;
  std::vector<std::pair<Vec, Real>> planes; ///< unit normals and offsets
  Real top_radius = 1;
  Mat inverse{1};
  Vec offset{0};
  Real size = 1, norm = 1, condition = 1;
};

/// One shape of a world.
class ExactBody {
public:
  explicit ExactBody(const PlacedShape& placed);

  [[nodiscard]] bool solid() const { return solid_; }
  [[nodiscard]] bool contains(const Vec& world) const;
  /// All crossings of the whole line, ascending; those of solids alternate.
  void crossings(const Vec& origin, const Vec& direction, std::vector<ExactCrossing>& found) const;
  /// How far off its place rounding may put a surface that a ray from `origin` meets at `t`.
  [[nodiscard]] Real blur(const Vec& origin, Real t) const;
  /// False when no surface of the body is closer than this; true may be a false alarm.
  [[nodiscard]] bool comes_near(const Vec& world, Real distance) const;
  /// Whether a place on the surface of a face is on the body's boundary when each other face is
  /// moved by `moved` at most, as rounding may move it.
  [[nodiscard]] bool may_show(FaceId face, const Vec& world, Real moved) const;
  /// How far a point of a flat shape's plane is inside its rim, in the world; negative outside.
  [[nodiscard]] Real inside_rim(const Vec& world) const;
  [[nodiscard]] Real distance(FaceId face, const Vec& world) const;
  [[nodiscard]] Vec normal(FaceId face, const Vec& world) const;
  [[nodiscard]] Real turn(FaceId face, const Vec& world, Real shift) const;

private:
  void mesh_crossings(const Vec& origin, const Vec& direction,
                      std::vector<ExactCrossing>& found) const;
  [[nodiscard]] bool comes_near(std::size_t triangle, const Vec& world, Real distance) const;
  [[nodiscard]] bool combine(const std::vector<bool>& in_leaf) const;

  bool solid_ = true;
  std::vector<ExactLeaf> leaves_;
  std::vector<bool> flipped_;
  std::vector<CsgTree::Step> steps_;
  std::vector<Vec> vertices_; ///< of a mesh, in the world
  std::vector<Triangle> triangles_;
  std::vector<Vec> normals_; ///< unit
  Real mesh_size_ = 0, mesh_condition_ = 1;
};

} // namespace abbe::stress
