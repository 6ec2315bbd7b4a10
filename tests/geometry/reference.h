#pragma once

#include "geometry/world/shape.h"

#include <glm/mat3x3.hpp>

#include <optional>
#include <vector>

// What the geometry tests compare with: the same solids in 80-bit arithmetic, by other means. A
// solid is a postfix expression of leaves whose membership is asked point by point; a crossing is a
// root of a leaf where the membership of the points on its two sides differs. No interval list is
// merged, no contact known, no bound of rounding used.
namespace abbe::reference {

using Real = long double;
using Vec = glm::vec<3, Real>;
using Mat = glm::mat<3, 3, Real>;

/// A solid of revolution when it has a taper (radius 1 at z = 0, `taper` at z = 1), else a unit
/// ball when it has no planes, else the points under all planes; in a frame of its own.
struct Leaf {
  std::vector<HalfSpace> planes;
  std::optional<Real> taper;
  Mat linear{1}, inverse{1};
  Vec offset{0};

  [[nodiscard]] bool contains(const Vec& world) const;
  /// Distance to the leaf's surfaces in the world, to first order.
  [[nodiscard]] Real clearance(const Vec& world) const;
  [[nodiscard]] Vec normal(int face, const Vec& world) const;
};

struct Step {
  int leaf = -1; ///< negative: combine the two topmost results
  CsgOperation operation = CsgOperation::unite;
};

struct Crossing {
  Real t = 0;
  bool entering = false;
  int leaf = 0, face = 0;
  Vec normal{0}; ///< outwards from the whole solid
};

struct Solid {
  std::vector<Leaf> leaves;
  std::vector<Step> steps;
  bool flat = false;                   ///< its one leaf serves for the plane's frame
  bool round = false, endless = false; ///< what a flat one covers; neither: a square

  [[nodiscard]] bool contains(const Vec& world) const;
  [[nodiscard]] Real clearance(const Vec& world) const;
  /// All crossings of the whole line, ascending. Roots closer than `tie` count as one.
  [[nodiscard]] std::vector<Crossing> crossings(const Vec& origin, const Vec& direction,
                                                Real tie = 0) const;
  void move(const glm::dmat3& linear, const dvec3& offset);
};

/// A shape as our code sees it and as the reference does.
struct Twin {
  PlacedShape placed;
  Solid solid;
};

/// A part of a tree while its twin is built.
struct Piece {
  CsgTree tree;
  Solid solid;
};

[[nodiscard]] Twin sphere();
[[nodiscard]] Twin box();
[[nodiscard]] Twin square();
[[nodiscard]] Twin disc();
[[nodiscard]] Twin plane();
[[nodiscard]] Twin tapered_cylinder(double top_radius);
[[nodiscard]] Twin polyhedron(const std::vector<HalfSpace>& planes);
[[nodiscard]] Twin prism();
[[nodiscard]] Twin csg(const Piece& piece);
[[nodiscard]] Piece piece(const Twin& convex);
[[nodiscard]] Piece combined(CsgOperation operation, const Piece& left, const Piece& right);
/// The twin mapped by x -> linear x + offset, after what it has been through already.
[[nodiscard]] Twin placed(Twin twin, const glm::dmat3& linear, const dvec3& offset);

} // namespace abbe::reference
