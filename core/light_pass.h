#pragma once

#include "core/camera.h"
#include "core/film.h"
#include "core/integrators/photon_map.h"
#include "core/lights/emission.h"
#include "core/statistics.h"

#include <atomic>

namespace abbe {

/// Light-side passes of a rendering: before each pass of camera samples as many light paths are
/// followed as the plan says; they add splats to the film and fill the photon map anew.
class LightPasses {
public:
  /// Keeps references.
  LightPasses(const Scene& scene, const Plan& plan, const World& world, const CameraRays& camera,
              Film& film);

  /// True when there is something to do; then `map` and `emission` are what camera paths need.
  [[nodiscard]] bool needed() const { return !emission_.emitters().empty(); }
  [[nodiscard]] const PhotonMap& map() const { return map_; }
  [[nodiscard]] const Emission& emission() const { return emission_; }

  /// Runs pass number `pass` for `samples` camera samples a pixel, within the current task arena.
  /// Setting `stop` ends it soon.
  RayCounts run(int pass, int samples, const std::atomic<bool>& stop, RayRecord* record);

private:
  const Plan& plan_;
  const World& world_;
  const CameraRays& camera_;
  Film& film_;
  Emission emission_;
  PhotonMap map_;
  double largest_radius_, first_radius_; ///< 0: not known yet
  std::vector<std::uint32_t> begun_;     ///< by emitter: paths of earlier passes
};

/// A radius within which photons like these give each of all bands a few dozen, at the median
/// photon.
[[nodiscard]] double radius_for(std::span<const PhotonBatch> batches, int bands_in_all,
                                double largest);

/// The radius of the photon map's pass: its square shrinks as pass^(-1/3) [Knaus11], so that both
/// noise and blur vanish.
[[nodiscard]] double photon_radius(double first_radius, int pass);

} // namespace abbe
