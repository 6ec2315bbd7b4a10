#pragma once

#include "core/bundles/fan.h"
#include "core/integrators/integrator.h"
#include "core/integrators/shadow.h"
#include "core/integrators/single_scatter.h"
#include "core/lamps/lamps.h"
#include "core/plan/plan.h"

#include <vector>

namespace abbe {

/// The thesis's model of light [War05, 4.6; Whitted80], per band: ambient, emitted, Lambert and
/// Phong (with Blinn's half vector) light of the lamps, and the trees of reflected and refracted
/// rays.
class Whitted final : public CameraIntegrator {
public:
  /// Keeps references to all.
  Whitted(const Scene& scene, const Plan& plan, const World& world, const Lamps& lamps,
          double pixel_angle);

  void trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
             RayCounts& counts) override;

private:
  /// Room for a bundle of bands [first, last) that waits for its turn; its throughput is the row of
  /// the same number. All but its bands is the caller's to fill; what was there is of no use.
  [[nodiscard]] Bundle& push(int first, int last, const float* throughput, float factor);
  [[nodiscard]] float* row(std::size_t i) { return throughputs_.data() + i * plan_.stride; }

  void add_background(const Bundle& bundle, RadianceSums& sums);
  void shade(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
             RayCounts& counts);
  [[nodiscard]] const float* diffuse_under_coat(const Bundle& bundle, const MaterialPlan& material,
                                                const BandTable& diffuse, double cos_o,
                                                double cos_i);
  void add_lamps(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                 RayCounts& counts);
  void scatter(const Bundle& bundle, const MaterialPlan& material, double choice,
               RayCounts& counts);
  void reflect(const Bundle& bundle, const float* factors, RayCounts& counts);
  void refract(const Bundle& bundle, double choice, RayCounts& counts);
  [[nodiscard]] double importance(float most, int first, MediumId medium);
  [[nodiscard]] double chance(double importance, BandRange bands) const;

  const Scene& scene_;
  const Plan& plan_;
  const World& world_;
  const Lamps& lamps_; ///< of which only the sky is seen
  PathWavelengths wavelengths_;
  Fan fan_;
  ShadowRays shadow_rays_;
  SingleScatter single_scatter_;
  std::vector<float> reflected_, transmitted_; ///< of the surface being shaded
  BandTable ones_, textured_;
  DecisionStream decisions_;

  Bundle bundle_; ///< on its way
  std::size_t waiting_count_ = 0;
  std::vector<Bundle> waiting_;    ///< the first so many wait; the others are room for more
  std::vector<float> throughputs_; ///< rows of Plan::stride values, one per waiting bundle
  std::vector<float> throughput_;  ///< of the bundle being shaded
  std::vector<float> lit_;         ///< the same after a shadow ray
  std::vector<float> coated_;      ///< the same after a coat, there and back
};

} // namespace abbe
