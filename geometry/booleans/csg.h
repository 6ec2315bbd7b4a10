#pragma once

#include "geometry/solids/convex.h"

#include <span>
#include <vector>

namespace abbe {

enum class CsgOperation : std::uint8_t { unite, intersect, subtract };

/// A convex solid at its place in a CSG tree.
struct CsgLeaf {
  Convex solid;
  Transform to_tree;
  MaterialId material;  ///< of this operand alone; invalid: that of the whole solid
  bool flipped = false; ///< subtracted an odd number of times: the solid lies outside this leaf
};

/// A boolean combination of convex solids, evaluated by merging interval lists along a line.
class CsgTree {
public:
  /// A tree of one leaf.
  CsgTree(Convex solid, const Transform& to_tree, MaterialId material = {});
  /// `left` operation `right`, both in the same frame.
  CsgTree(CsgOperation operation, CsgTree left, CsgTree right);

  [[nodiscard]] const std::vector<CsgLeaf>& leaves() const { return leaves_; }
  /// The same tree seen from a frame that `outer` maps this tree's frame to.
  [[nodiscard]] CsgTree moved(const Transform& outer) const;

  /// One step of the evaluation in postfix order: push a leaf, or combine the two topmost results.
  struct Step {
    std::int32_t leaf = -1; ///< negative: `operation` applies
    CsgOperation operation = CsgOperation::unite;
  };
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }

private:
  std::vector<CsgLeaf> leaves_;
  std::vector<Step> steps_;
};

/// A ray's origin lies on the face `face` of leaf `leaf`; `side` is that of the leaf, not of the
/// whole solid.
struct CsgContact {
  std::int32_t leaf = -1;
  FaceContact face;
};

/// Appends to `intervals` the parts of the line inside the solid, ascending and disjoint. Of
/// several contacts with one leaf the first counts. Allocates nothing once `intervals` has grown to
/// its working size.
void intersect(const CsgTree& tree, const LocalRay& ray, std::span<const CsgContact> contacts,
               std::vector<Interval>& intervals);
[[nodiscard]] dvec3 outward_normal(const CsgTree& tree, const dvec3& point, FaceId face);
[[nodiscard]] dvec3 snapped(const CsgTree& tree, const dvec3& point, FaceId face);
/// A face, and how far a ray would have to be moved to leave by it at its origin: by its distance
/// from the origin, and where a curved face is run in from also by the depth of the chord below it.
struct WayOut {
  FaceId face;
  double move = kInfinity;
};
/// The face by which a ray leaves that should be inside and is not, by the least move. No ray
/// leaves by a plane face that it runs in from.
[[nodiscard]] WayOut nearest_way_out(const CsgTree& tree, const dvec3& point,
                                     const dvec3& direction);
/// Negative inside, positive outside; only the sign is meaningful far from the surface.
[[nodiscard]] double signed_distance(const CsgTree& tree, const dvec3& point);
[[nodiscard]] Bounds bounds(const CsgTree& tree, const Transform& to_world);

} // namespace abbe
