#pragma once

#include "core/cameras/placed_camera.h"
#include "core/film/film.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/bundle_walk.h"
#include "core/integrators/photon_map.h"
#include "core/integrators/shadow.h"
#include "core/lights/emission.h"

namespace abbe {

/// Light paths: from a lamp by way of mirrors and glass to the first surfaces that spread the
/// light. There they are connected to the camera (a splat), and kept for the photon map; from there
/// they may go by mirrors and glass once more, to a surface that the camera sees. One object serves
/// one thread.
class LightPaths : private BundleWalk {
public:
  /// Keeps references. `camera` is null where what the camera sees cannot be connected to.
  LightPaths(const Plan& plan, const World& world, const Emission& emission,
             const PlacedCamera* camera, Film& film);

  /// Follows one path. `share` is what one path stands for: 1 over their number. Photons are added
  /// to `photons` unless it is null; `photon_share` is the same for those.
  void trace(const EmittedRay& ray, const Sampler& sampler, double share, PhotonBatch* photons,
             double photon_share, RayCounts& counts);

private:
  void follow();
  bool go_on();
  /// Takes the bundle to what its ray meets, with what the way absorbs. False where that is
  /// nothing.
  bool arrive();
  void splat(const Hit& hit);
  void keep(const Hit& hit);
  void go_on_from_spread(const Hit& hit);

  const Emission& emission_;
  const PlacedCamera* camera_;
  Film& film_;
  ShadowRays to_camera_;
  RadianceSums sums_;
  std::vector<float> light_; ///< scratch
  int source_ = 0;
  double flux_ = 0.0, share_ = 0.0, photon_share_ = 0.0;
  PhotonBatch* photons_ = nullptr;
};

} // namespace abbe
