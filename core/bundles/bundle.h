#pragma once

#include "core/bands/band_range.h"
#include "core/bundles/ray_record.h"
#include "core/film/light_class.h"
#include "geometry/rays/passage.h"
#include "geometry/rays/ray_state.h"

#include <cstddef>
#include <cstdint>

namespace abbe {

/// How a camera path has come to its ray. Only what shows *through* the scene belongs to the
/// picture behind it; see core/integrators/sky_view.h. Panes and drops on the way change nothing.
enum class Route : std::uint8_t {
  direct,    ///< no surface has turned it
  reflected, ///< surfaces that also let light through have reflected it, and none has let it
             ///< through
  through,   ///< some surface has let it through, and all that reflected it let light through too
  opaque     ///< a surface that lets no light through has sent it on
};
[[nodiscard]] constexpr Route let_through(Route route) {
  return route == Route::opaque ? Route::opaque : Route::through;
}
/// `clear`: the surface also lets light through.
[[nodiscard]] constexpr Route sent_back(Route route, bool clear) {
  if (!clear) return Route::opaque;
  return route == Route::direct ? Route::reflected : route;
}

/// A contiguous range of bands that share one ray. Its throughput per band lies beside it.
struct Bundle {
  BandRange bands;
  RayState state;
  RayKind kind = RayKind::camera; ///< what sent the ray
  Route route = Route::direct;
  View view = View::direct; ///< what the first surface has done with the path
  bool traced = false;      ///< whether `hit` is known already, see extend.h
  Hit hit;                  ///< what the ray meets next
  bool straight_on = false; ///< the ray goes on behind a boundary that bends no light
  Passage passage;          ///< what the ray must remember of such boundaries
  int depth = 0;            ///< how many surfaces the path has met so far
  int panes = 0;            ///< how many panes it went straight through, which do not count
  /// How many surfaces it has met, panes too.
  [[nodiscard]] int surfaces() const { return depth + panes; }
  double path_length = 0.0; ///< from the camera to the ray's origin
  /// How much of `path_length` belongs to the ray itself: before its origin it has passed
  /// boundaries that are not seen.
  double unseen_length = 0.0;

  /// The pdf per steradian with which the ray's direction was sampled from a BSDF; 0 after a
  /// specular reflection or refraction, and for a ray of the camera.
  double pdf = 0.0;
  int nonspecular_bounces = 0;     ///< how many surfaces have scattered it other than specularly
  int first_nonspecular_depth = 0; ///< its depth before the first of them
  /// Whether a pixel's width tells which rays are close together. It no longer does once a surface
  /// has scattered the path other than specularly, and on a light path it never does.
  bool has_pixel_footprint = true;

  // The bundle's own footprint: how far the rays of its outermost bands would have moved apart by
  // now, had each its own. Both are 0 for a single band.
  double separation = 0.0; ///< of their origins
  double divergence = 0.0; ///< of their directions
};

/// The view of what sets off from a bundle's hit, sent by a reflection or the like.
[[nodiscard]] inline View view_on(const Bundle& bundle, RayKind kind) {
  if (bundle.depth > 0) return bundle.view;
  return kind == RayKind::reflected   ? View::reflection
         : kind == RayKind::refracted ? View::refraction
                                      : View::direct;
}

/// Makes `next`, which may be `bundle` itself, set off from its hit along a direction, untraced.
/// `through` tells whether it goes to the other side of the surface. Its bands are the caller's,
/// and so are its pdf where the direction is not specular, and its route where the surface lets no
/// light through.
inline void set_off(const Bundle& bundle, const dvec3& direction, bool through, RayKind kind,
                    Bundle& next) {
  const Hit& hit = bundle.hit;
  next.separation = bundle.separation + bundle.divergence * hit.t;
  next.divergence = bundle.divergence;
  next.path_length = bundle.path_length + hit.t;
  next.unseen_length = 0.0;
  next.pdf = 0.0;
  next.route = through ? let_through(bundle.route) : sent_back(bundle.route, true);
  next.view = view_on(bundle, kind);
  next.depth = bundle.depth + 1;
  next.panes = bundle.panes;
  next.nonspecular_bounces = bundle.nonspecular_bounces;
  next.first_nonspecular_depth = bundle.first_nonspecular_depth;
  next.has_pixel_footprint = bundle.has_pixel_footprint;
  next.state.ray = {hit.point, direction};
  hit.go_on(through, next.state.contacts, next.state.nesting);
  next.kind = kind;
  next.traced = false;
  next.straight_on = false;
}

/// One of the bundles that a camera sample starts with. Its ray, and what that meets, lie beside
/// it. The bands of a sample start as one bundle, unless a lens has parted them; bands that are
/// in none of them carry nothing.
struct CameraBundle {
  BandRange bands;
  float weight = 1.0f;                       ///< on what its bands carry
  double separation = 0.0, divergence = 0.0; ///< as of a Bundle
};

/// The bundles of one camera sample with their rays, and what those meet.
struct CameraPaths {
  const CameraBundle* bundles;
  const RayState* states;
  const Hit* hits;
  std::size_t count;

  /// Makes `bundle` the bundle number `i` as it starts.
  void begin(std::size_t i, Bundle& bundle) const {
    bundle.bands = bundles[i].bands;
    bundle.state = states[i];
    bundle.kind = RayKind::camera;
    bundle.route = Route::direct;
    bundle.view = View::direct;
    bundle.traced = true;
    bundle.straight_on = false;
    bundle.hit = hits[i];
    bundle.depth = bundle.panes = 0;
    bundle.path_length = bundle.unseen_length = bundle.pdf = 0.0;
    bundle.nonspecular_bounces = bundle.first_nonspecular_depth = 0;
    bundle.has_pixel_footprint = true;
    bundle.separation = bundles[i].separation;
    bundle.divergence = bundles[i].divergence;
  }
};

} // namespace abbe
