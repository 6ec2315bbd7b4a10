#pragma once

#include "core/bands/band_range.h"
#include "geometry/ray_state.h"

#include <cstddef>

namespace abbe {

/// A contiguous range of bands that share one ray. Its throughput per band lies beside it.
struct Bundle {
  int first = 0, last = 0; ///< bands [first, last)
  RayState state;
  Hit hit;                  ///< what the ray meets next; a ray is traced before its bundle is kept
  int depth = 0;            ///< surfaces met so far
  double path_length = 0.0; ///< from the camera to the ray's origin
  double passed = 0.0;      ///< of the ray before its origin, through boundaries that are not seen
  /// With which the ray's direction was chosen where it was last spread, per steradian; 0 when it
  /// comes straight from a mirror, a refracting surface, or the camera.
  double density = 0.0;
  int spreads = 0;      ///< how many surfaces have spread it
  int first_spread = 0; ///< how many it had met before the first of them
  bool spread = false;  ///< the path has met a surface that spreads light: no pixel's width is left

  // How far apart the rays of its outermost bands have drifted, had each its own ray: in position
  // at the ray's origin, and in direction. 0 for a single band.
  double position_spread = 0.0;
  double direction_spread = 0.0;

  [[nodiscard]] int bands() const { return last - first; }
};

/// Makes `next`, which may be `bundle` itself, set off from its hit along a direction, untraced.
/// `through`: to the other side of the surface. Its bands and density are the caller's.
inline void set_off(const Bundle& bundle, const dvec3& direction, bool through, Bundle& next) {
  const Hit& hit = bundle.hit;
  next.position_spread = bundle.position_spread + bundle.direction_spread * hit.t;
  next.direction_spread = bundle.direction_spread;
  next.path_length = bundle.path_length + hit.t;
  next.passed = 0.0;
  next.depth = bundle.depth + 1;
  next.spreads = bundle.spreads;
  next.first_spread = bundle.first_spread;
  next.spread = bundle.spread;
  next.state.ray = {hit.point, direction};
  next.state.contacts = through ? hit.other_side : hit.same_side;
  next.state.nesting = through ? hit.nesting_after : hit.nesting_before;
}

/// One of the bundles that a camera sample starts with; its ray and what that meets lie beside it.
/// A sample's bands have one bundle together, unless a lens has parted them; bands that are not in
/// any carry nothing.
struct CameraBundle {
  int first = 0, last = 0;                              ///< bands [first, last)
  float weight = 1.0f;                                  ///< on what its bands carry
  double position_spread = 0.0, direction_spread = 0.0; ///< as of a Bundle
};

/// The bundles of one camera sample with their rays, and what those meet.
struct CameraPaths {
  const CameraBundle* bundles;
  const RayState* states;
  const Hit* hits;
  std::size_t count;

  /// Makes `bundle` the bundle number `i` as it starts.
  void begin(std::size_t i, Bundle& bundle) const {
    bundle.first = bundles[i].first;
    bundle.last = bundles[i].last;
    bundle.state = states[i];
    bundle.hit = hits[i];
    bundle.depth = 0;
    bundle.path_length = bundle.passed = bundle.density = 0.0;
    bundle.spreads = bundle.first_spread = 0;
    bundle.spread = false;
    bundle.position_spread = bundles[i].position_spread;
    bundle.direction_spread = bundles[i].direction_spread;
  }
};

} // namespace abbe
