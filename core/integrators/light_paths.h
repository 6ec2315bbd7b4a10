#pragma once

#include "core/cameras/placed_camera.h"
#include "core/film/film.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/photon_map.h"
#include "core/integrators/random_walk.h"
#include "core/integrators/shadow.h"
#include "core/lights/emission.h"

namespace abbe {

/// Light paths go from a light by way of mirrors and glass to the first surfaces that scatter the
/// light other than specularly. There they are connected to the camera (a splat), and kept for the
/// photon map; from there they may go by mirrors and glass once more, to a surface that the camera
/// sees. One object serves one thread.
class LightPaths : private RandomWalk {
public:
  /// Keeps references. `camera` is null where what the camera sees cannot be connected to.
  LightPaths(const Plan& plan, const World& world, const Emission& emission,
             const PlacedCamera* camera, Film& film);

  /// Follows one path. `share` is what one path stands for: 1 over their number. Photons are added
  /// to `photons` unless it is null; `photon_share` is the same for those.
  void trace(const EmittedRay& ray, const Sampler& sampler, double share, PhotonBatch* photons,
             double photon_share, RayCounts& counts);

private:
  /// Starts the bundle of a path. False where its light is dark in all bands.
  bool start(const EmittedRay& ray);
  /// Takes the traced bundle to what its ray has met, less what the medium absorbs. False where
  /// that is a boundary that is not seen: the bundle then goes on behind it, untraced.
  bool arrive();
  /// Leaves the traced bundle's light where it has arrived. What goes on from there waits.
  void shade();
  [[nodiscard]] bool beyond_limit() const { return bundle().depth >= limit_; }
  void splat(const Hit& hit);
  void keep(const Hit& hit);
  void branch_off_to_specular(const Hit& hit);

  const Emission& emission_;
  const PlacedCamera* camera_;
  Film& film_;
  std::optional<LayerId> lost_splats_;
  ShadowRays to_camera_;
  RadianceSums sums_;
  std::vector<float> light_; ///< scratch
  int source_ = 0;
  double flux_ = 0.0, share_ = 0.0, photon_share_ = 0.0;
  PhotonBatch* photons_ = nullptr;
  int limit_;                ///< of depth
  bool goes_beyond_ = false; ///< whether the path goes on where the depth limit ends it
};

} // namespace abbe
