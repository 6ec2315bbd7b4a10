#pragma once

#include "geometry/rays/ray_state.h"
#include "geometry/world/shape_table.h"

#include <algorithm>

namespace abbe {

/// One shape's crossing, as a candidate for what a ray meets next.
struct Candidate {
  ShapeId shape;
  ShapeCrossing crossing;
};

/// Crossings that rounding cannot tell apart, by distance, then shape.
using Coincident = ShortVector<Candidate, 8>;

/// The candidates nearest to a ray's origin: all crossings that rounding cannot tell from the
/// first. The content does not depend on the order in which candidates come.
class NearestCandidates {
public:
  /// Keeps the candidate if it can belong to the nearest boundary. Returns whether it was kept.
  bool offer(ShapeId shape, const ShapeCrossing& crossing) {
    if (crossing.t - crossing.t_error > reach_) return false;
    reach_ = std::min(reach_, crossing.t + crossing.t_error);
    if (kept_.empty())
      kept_.push_back({shape, crossing});
    else
      offer_beside_others({shape, crossing});
    return true;
  }
  [[nodiscard]] bool empty() const { return kept_.empty(); }
  void clear() {
    kept_.clear();
    reach_ = kInfinity;
  }
  /// Beyond this distance nothing can belong to the nearest boundary any more.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Coincident& boundary() const { return kept_; }

private:
  void offer_beside_others(const Candidate& candidate);

  Coincident kept_;
  double reach_ = kInfinity;
};

/// The medium at a place inside several solids.
[[nodiscard]] MediumId prevailing_medium(const ShapeTable& shapes, const Nesting& nesting);

/// The medium at a place inside these solids; see World::medium_of. Nearly all places lie inside
/// one solid or none.
[[nodiscard]] inline MediumId medium_of(const ShapeTable& shapes, const Nesting& nesting) {
  if (nesting.empty()) return {};
  return nesting.size() == 1 ? shapes[nesting[0]].medium : prevailing_medium(shapes, nesting);
}

/// Whether `a` shows where its surface coincides with that of `b`: what gives way behind all
/// else, an opaque or flat shape before glass, then the highest priority, then the shape defined
/// last (as for medium_of).
[[nodiscard]] bool shows_before(const ShapeTable& shapes, ShapeId a, ShapeId b);

/// What the ray meets at the nearest boundary, all coinciding crossings taken as one. A shape
/// without a medium (opaque or flat) shows before any other; else the one whose medium prevails.
/// Writes it to `hit`, whatever that held. Returns false where nothing is to be seen, since the
/// media on both sides are equal.
[[nodiscard]] bool resolve(const ShapeTable& shapes, const RayState& state,
                           const Coincident& crossings, Hit& hit);

} // namespace abbe
