#pragma once

#include "core/bands/band_span.h"
#include "core/bundles/bundle.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/shadow.h"
#include "core/lights/lights.h"
#include "core/sampling/sampler.h"

#include <vector>

namespace abbe {

/// The light that drops scatter once into the rays of a path. One object serves one
/// thread.
///
/// Along a stretch of length T through drops of extinction s, a band gathers
///   L = integral from 0 to T of s exp(-(s + a) t) p(angle) E(t) V(t) dt,
/// where a is the absorption between the drops, p their phase function, E the light's irradiance
/// and V what of it arrives. One place is drawn per stretch, with the pdf s exp(-s t) / (1 - exp(-s
/// T)).
class SingleScatter {
public:
  /// Each place gets the light of all the scene's lights. Keeps references to all.
  SingleScatter(const Scene& scene, const Plan& plan, const World& world);
  /// Each place gets the light of one light, drawn. Keeps references to all.
  SingleScatter(const Lights& lights, const Plan& plan, const World& world);

  /// Starts a path, whose drops send their light to `sums`. Keeps references to all but the
  /// sampler.
  void begin_path(const Sampler& sampler, PathWavelengths& wavelengths, RadianceSums& sums,
                  RayCounts& counts);

  /// From now on drops send their light to `sums`.
  void send_to(RadianceSums& sums, RayCounts& counts) {
    sums_ = &sums;
    counts_ = &counts;
  }

  /// Takes a bundle along its ray, which has been traced, to what the ray meets. Its throughput
  /// arrives there less what the medium absorbs, and what drops on the way send is added. False
  /// where the ray has met a boundary of drops, which is not seen itself: the bundle then goes on
  /// behind it, untraced.
  [[nodiscard]] bool arrive(Bundle& bundle, BandSpan<float> throughput);

private:
  /// What a light sends to a place: `weight` times its spectrum is irradiance.
  struct IncomingLight {
    dvec3 direction;
    double distance, weight;
    int source;
    bool disc; ///< parallel light whose disc has not been sampled
    std::optional<LightSample> sample;
  };
  void add(const Bundle& bundle, double length, const MediumPlan& medium,
           BandSpan<const float> throughput);
  void find_lights(const dvec3& place);

  const Scene* scene_ = nullptr;
  const Lights* lights_ = nullptr;
  const Plan& plan_;
  const World& world_;
  ShadowRays shadow_rays_;
  BandTable ones_;
  PathWavelengths* wavelengths_ = nullptr;
  RadianceSums* sums_ = nullptr;
  RayCounts* counts_ = nullptr;
  dvec2 place_{0.5}, light_point_{0.5};
  std::vector<IncomingLight> incoming_; ///< those that shine on the place drawn
  std::vector<float> seen_;             ///< the throughput there
  std::vector<float> lit_;              ///< the same times what a light sends
};

} // namespace abbe
