#pragma once

#include "geometry/ray_state.h"
#include "geometry/shape.h"

#include <vector>

namespace abbe {

/// One shape's crossing, as a candidate for what a ray meets next.
struct Candidate {
  ShapeId shape;
  ShapeCrossing crossing;
};

/// Crossings that rounding cannot tell apart, by distance, then shape.
using Coincident = FixedVector<Candidate, 8>;

/// The candidates nearest to a ray's origin: all crossings that rounding cannot tell from the
/// first. The content does not depend on the order in which candidates come.
class NearestCandidates {
public:
  /// Keeps the candidate if it can belong to the nearest boundary. True when it was kept.
  bool offer(const Candidate& candidate);
  [[nodiscard]] bool empty() const { return kept_.empty(); }
  void clear() {
    kept_.clear();
    reach_ = kInfinity;
  }
  /// Beyond this distance nothing can belong to the nearest boundary any more.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Coincident& boundary() const { return kept_; }

private:
  Coincident kept_;
  double reach_ = kInfinity;
};

/// The medium at a place inside these solids; see World::medium_of.
[[nodiscard]] MediumId medium_of(const std::vector<PlacedShape>& shapes, const Nesting& nesting);

/// What the ray meets at the nearest boundary, all coinciding crossings taken as one. A shape
/// without a medium (opaque or flat) shows before any other; else the one whose medium prevails.
/// `visible` is false where nothing is to be seen: equal media on both sides.
struct Boundary {
  Hit hit;
  bool visible = true;
};
[[nodiscard]] Boundary resolve(const std::vector<PlacedShape>& shapes, const RayState& state,
                               const Coincident& crossings);

} // namespace abbe
