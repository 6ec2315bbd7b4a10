#pragma once

#include "geometry/ray_state.h"

#include <optional>

namespace abbe {

/// A contiguous range of bands that share one ray. Its throughput per band lies beside it.
struct Bundle {
  int first = 0, last = 0; ///< bands [first, last)
  RayState state;
  std::optional<Hit> hit;   ///< what the ray meets next; a ray is traced before its bundle is kept
  int depth = 0;            ///< surfaces met so far
  double path_length = 0.0; ///< from the camera to the ray's origin
  double passed = 0.0;      ///< of the ray before its origin, through boundaries that are not seen
  /// With which the ray's direction was chosen where it was last spread, per steradian; 0 when it
  /// comes straight from a mirror, a refracting surface, or the camera.
  double density = 0.0;
  bool spread = false; ///< the path has met a surface that spreads light: no pixel's width is left

  // How far apart the rays of its outermost bands have drifted, had each its own ray: in position
  // at the ray's origin, and in direction. 0 for a single band.
  double position_spread = 0.0;
  double direction_spread = 0.0;

  [[nodiscard]] int bands() const { return last - first; }
};

} // namespace abbe
