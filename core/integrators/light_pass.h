#pragma once

#include "core/bundles/statistics.h"
#include "core/cameras/placed_camera.h"
#include "core/film/film.h"
#include "core/integrators/photon_map.h"
#include "core/lights/emission.h"

#include <atomic>

namespace abbe {

/// Light-side passes of a rendering: before each pass of camera samples as many light paths are
/// followed as the plan says; they add splats to the film and fill the photon map anew.
class LightPasses {
public:
  /// Keeps references. `camera` is null where it cannot be connected with; camera paths then look
  /// up photons where light paths would have been splatted.
  LightPasses(const Scene& scene, const Plan& plan, const World& world, const PlacedCamera* camera,
              Film& film);

  /// True when there is something to do; then `map` and `emission` are what camera paths need.
  [[nodiscard]] bool needed() const { return !emission_.lights().empty(); }
  [[nodiscard]] const PhotonMap& map() const { return map_; }
  [[nodiscard]] const Emission& emission() const { return emission_; }
  /// How long the passes have taken.
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Runs pass number `pass` for `samples` camera samples a pixel, within the current task arena.
  /// Setting `stop` ends it soon.
  RayCounts run(int pass, int samples, const std::atomic<bool>& stop, RayRecord* record);

private:
  const Plan& plan_;
  const World& world_;
  const PlacedCamera* camera_;
  Film& film_;
  Emission emission_;
  PhotonMap map_;
  double largest_radius_, first_radius_; ///< 0: not known yet
  double seconds_ = 0.0;
  std::vector<std::uint32_t> begun_; ///< by emitter: paths of earlier passes
};

} // namespace abbe
