#pragma once

#include "core/bundles/bundle.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/shadow.h"
#include "core/lights/lights.h"
#include "core/sampling/sampler.h"

#include <vector>

namespace abbe {

/// Light of the lamps that drops scatter once, into the rays of a path. Of one thread.
///
/// Along a stretch of length T through drops of extinction s, a band gathers
///   L = integral from 0 to T of s exp(-(s + a) t) p(angle) E(t) V(t) dt,
/// a the absorption between the drops, p their phase function, E the lamp's irradiance and V what
/// of it arrives. One place is drawn per stretch, with the density s exp(-s t) / (1 - exp(-s T)).
class SingleScatter {
public:
  /// Each place gets the light of all the scene's lights. Keeps references to all.
  SingleScatter(const Scene& scene, const Plan& plan, const World& world);
  /// Each place gets the light of one lamp, drawn. Keeps references to all.
  SingleScatter(const Lights& lamps, const Plan& plan, const World& world);

  void begin_path(const Sampler& sampler);

  /// Takes a bundle along its ray to what is seen, through boundaries of drops, which are not seen
  /// themselves. Its throughput arrives there less what the ways absorb; what the drops on them
  /// send is added.
  void arrive(Bundle& bundle, float* throughput, PathWavelengths& wavelengths, RadianceSums& sums,
              RayCounts& counts);

private:
  /// What a lamp sends to a place: `weight` times its spectrum is irradiance.
  struct Light {
    dvec3 direction;
    double distance, weight;
    int source;
    bool disc; ///< parallel light whose disc has not been sampled
    std::optional<LightSample> sample;
  };
  void add(const Bundle& bundle, double way, const MediumPlan& medium, const float* throughput,
           PathWavelengths& wavelengths, RadianceSums& sums, RayCounts& counts);
  void find_lights(const dvec3& place);

  const Scene* scene_ = nullptr;
  const Lights* lamps_ = nullptr;
  const Plan& plan_;
  const World& world_;
  ShadowRays shadow_rays_;
  BandTable ones_;
  dvec2 place_{0.5}, lamp_point_{0.5};
  std::vector<Light> lights_;     ///< that shine on the place drawn
  std::vector<float> seen_, lit_; ///< throughput there, and times what a lamp sends
};

} // namespace abbe
