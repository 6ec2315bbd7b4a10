#pragma once

#include "core/integrators/shadow.h"
#include "core/radiance_sums.h"

#include <vector>

namespace abbe {

/// Light of the lamps that drops scatter once, straight to the camera. Of one thread.
///
/// Along a stretch of length T through drops of extinction s, a band gathers
///   L = integral from 0 to T of s exp(-(s + a) t) p(angle) E(t) V(t) dt,
/// a the absorption between the drops, p their phase function, E the lamp's irradiance and V what
/// of it arrives. One place is drawn per stretch, with the density s exp(-s t) / (1 - exp(-s T)).
class SingleScatter {
public:
  SingleScatter(const Scene& scene, const Plan& plan, const World& world);

  /// Starts a camera path. `place` from 0 to 1 chooses the places on all its stretches.
  void begin_path(double place) { place_ = place; }

  /// Adds what comes to the origin of a ray whose next `way` is through `medium`, for bands [first,
  /// last). `throughput` is that at the origin. Nothing for a medium without drops.
  void add(const RayState& state, double way, MediumId medium, int first, int last,
           const float* throughput, PathWavelengths& wavelengths, RadianceSums& sums,
           RayCounts& counts);

private:
  const Scene& scene_;
  const Plan& plan_;
  const World& world_;
  ShadowRays shadow_rays_;
  BandTable ones_;
  std::vector<float> seen_, lit_; ///< throughput at the place drawn, and times what a lamp sends
  double place_ = 0.5;
};

} // namespace abbe
