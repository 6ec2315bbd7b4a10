#pragma once

#include "core/bands/band_span.h"
#include "core/bundles/path_wavelengths.h"
#include "core/bundles/statistics.h"
#include "core/lights/lights.h"
#include "geometry/world/world.h"

#include <vector>

namespace abbe {

/// Shadow rays of one thread.
class ShadowRays {
public:
  ShadowRays(const Plan& plan, const World& world);

  /// What of a light's light arrives along a straight shadow ray, per band; null where none does.
  /// Full transmittance is a band array of ones. The array is valid until the next call.
  [[nodiscard]] const float* transmittance(const RayState& towards_light, double distance,
                                           BandRange bands, PathWavelengths& wavelengths,
                                           RayCounts& counts);
  /// The same for a sample of a light: nothing arrives from a place of a shape where another one
  /// shows.
  [[nodiscard]] const float* transmittance(const RayState& towards_light, const LightSample& light,
                                           BandRange bands, PathWavelengths& wavelengths,
                                           RayCounts& counts) {
    if (light.may_be_hidden.valid() && hidden(towards_light.ray, light)) return nullptr;
    return transmittance(towards_light, light.distance, bands, wavelengths, counts);
  }
  /// The same along any straight line, whatever the scene says of shadows.
  [[nodiscard]] const float* along(const RayState& state, double distance, BandRange bands,
                                   PathWavelengths& wavelengths, RayCounts& counts);
  /// True when the last one that arrived went through glass.
  [[nodiscard]] bool through_glass() const { return through_glass_; }

private:
  /// The thesis's shadow rays go straight through what bends light; panes and drops let all pass.
  [[nodiscard]] bool through_refracting() const {
    return plan_.settings.shadows == ShadowRule::attenuated;
  }
  [[nodiscard]] bool hidden(const Ray& towards_light, const LightSample& light) const;
  /// False where nothing arrives.
  [[nodiscard]] bool attenuate(RayState state, double distance, BandRange bands,
                               PathWavelengths& wavelengths, RayCounts& counts);
  void pass(const MaterialPlan& material, const Hit& hit, double cos_i, BandSpan<float> light,
            PathWavelengths& wavelengths);

  const Plan& plan_;
  const World& world_;
  std::vector<float> ones_, transmittance_;
  bool through_glass_ = false;
};

} // namespace abbe
