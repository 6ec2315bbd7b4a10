#pragma once

#include "core/cameras/placed_camera.h"
#include "core/film/film.h"
#include "core/film/part_layers.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/end_check.h"
#include "core/integrators/photon_map.h"
#include "core/integrators/random_walk.h"
#include "core/integrators/shadow.h"
#include "core/lights/emission.h"

namespace abbe {

/// Light paths go from a light by way of mirrors and glass to the first surfaces that scatter the
/// light other than specularly. There they are connected to the camera (a splat), and kept for the
/// photon map; from there they may go by mirrors and glass once more, to a surface that the camera
/// sees. One object serves one thread.
///
/// The splats of a chunk of paths are held back until the whole chunk has been followed, so that a
/// chunk that is given up leaves nothing in the film and can be followed anew.
class LightPaths : private RandomWalk {
public:
  /// Keeps references. `camera` is null where what the camera sees cannot be connected to.
  LightPaths(const Plan& plan, const World& world, const Emission& emission,
             const PlacedCamera* camera, Film& film);
  /// Long paths ask this now and then. Keeps a reference.
  void end_with(const IsOver& is_over) { end_check_.end_with(is_over); }

  /// Follows one path, and returns false where it was given up. `share` is what one path stands
  /// for: 1 over their number. Photons are added to `photons` unless it is null; `photon_share` is
  /// the same for those.
  bool trace(const EmittedRay& ray, const Sampler& sampler, double share, PhotonBatch* photons,
             double photon_share, RayCounts& counts);
  /// Says whether the splats of the paths that follow belong to the half of all that is kept apart.
  void set_half(bool first) { first_half_ = first; }

  /// Adds the splats that are held back to the film.
  void add_splats();
  /// Forgets the splats that are held back.
  void drop_splats();

private:
  /// A splat that is not in the film yet.
  struct HeldSplat {
    int x, y;
    Xyz color;
    double rounding; ///< the random number that rounds it
    bool lost;       ///< it lies beyond the depth limit, which takes it from the picture
    int source;      ///< index into Plan::sources
    Arrival arrival;
    bool first_half; ///< of the light paths
  };

  /// Starts the bundle of a path. False where its light is dark in all bands.
  bool start(const EmittedRay& ray);
  /// Takes the traced bundle to what its ray has met, less what the medium absorbs. False where
  /// that is a boundary that is not seen: the bundle then goes on behind it, untraced.
  bool arrive();
  /// Leaves the traced bundle's light where it has arrived. What goes on from there waits.
  void shade();
  [[nodiscard]] bool beyond_limit() const { return bundle().depth >= limit_; }
  void splat(const Hit& hit);
  /// Holds back a splat of what the sums hold.
  void hold_back(int x, int y);
  void keep(const Hit& hit);
  void branch_off_to_specular(const Hit& hit);

  const Emission& emission_;
  const PlacedCamera* camera_;
  Film& film_;
  std::optional<LayerId> lost_splats_, half_splats_;
  ShadowRays to_camera_;
  RadianceSums sums_;
  std::vector<float> light_; ///< scratch
  int source_ = 0;
  double flux_ = 0.0, share_ = 0.0, photon_share_ = 0.0;
  PhotonBatch* photons_ = nullptr;
  int limit_;                ///< of depth
  bool goes_beyond_ = false; ///< whether the path goes on where the depth limit ends it
  bool first_half_ = false;  ///< the path belongs to the half that is kept apart
  EndCheck end_check_;
  std::vector<HeldSplat> held_;
  std::vector<float> held_radiance_; ///< of the splats that are not lost, where the film has bands
  PartLayers part_layers_;
  RadianceParts parts_;          ///< of the splat that `sums_` holds
  std::vector<float> held_unit_; ///< of the splats that are not lost, of a relightable rendering
  std::vector<Xyz> held_bands_;  ///< the same, of one with band images
};

} // namespace abbe
