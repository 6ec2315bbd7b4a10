#pragma once

#include "core/fan.h"
#include "core/integrators/integrator.h"
#include "core/integrators/shadow.h"
#include "core/integrators/single_scatter.h"
#include "core/lights/lamps.h"
#include "core/materials/scattering.h"

#include <vector>

namespace abbe {

/// Global illumination by random paths from the camera [Kajiya86], per band, for whole bundles of
/// bands: one way on from each surface, lamps aimed at wherever light is spread, both ways of
/// reaching a lamp weighed against each other [Veach97], and paths that carry little ended at
/// random. Unbiased at a fixed number of samples.
class Path final : public CameraIntegrator {
public:
  /// Keeps references to all.
  Path(const Plan& plan, const World& world, const Lamps& lamps, double pixel_angle);

  void trace(const RayState& camera_ray, const std::optional<Hit>& hit, const Sampler& sampler,
             RadianceSums& sums, RayCounts& counts) override;

private:
  /// A sub-bundle that waits for its turn; its throughput is the row of the same number.
  void push(const Bundle& bundle, float weight);
  [[nodiscard]] float* row(std::size_t i) { return throughputs_.data() + i * plan_.stride; }

  /// Follows the current bundle to its end; sub-bundles that part from it are pushed.
  void follow();
  /// Adds what the bundle sees by itself: the background, or light that a surface emits.
  void gather();
  void aim_at_a_lamp(const Hit& hit);
  /// Makes the bundle go on from its hit. False where it ends.
  bool go_on();
  bool reflect(double chance);
  bool refract(double chance);
  bool spread();
  bool leave(const dvec3& direction, RayKind kind);
  bool resume();
  bool survives(MediumId medium);
  void scale(const float* factors, double weight);
  [[nodiscard]] dvec2 numbers(SamplePurpose purpose) const;

  const Plan& plan_;
  const World& world_;
  const Lamps& lamps_;
  PathWavelengths wavelengths_;
  Fan fan_;
  ShadowRays shadow_rays_;
  SingleScatter single_scatter_;
  Scattering scattering_;
  BandTable ones_;

  // Of the sample being followed.
  const Sampler* sampler_ = nullptr;
  RadianceSums* sums_ = nullptr;
  RayCounts* counts_ = nullptr;
  double band_choice_ = 0.0;
  double importance_ = 1.0; ///< of the current bundle behind its last hit

  Bundle bundle_;                 ///< being followed
  std::vector<float> throughput_; ///< of it
  std::vector<float> light_;      ///< scratch: what one source gives
  std::vector<Bundle> waiting_;
  std::vector<float> throughputs_; ///< rows of Plan::stride values, one per waiting bundle
};

} // namespace abbe
