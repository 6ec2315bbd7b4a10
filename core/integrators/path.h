#pragma once

#include "core/integrators/bundle_walk.h"
#include "core/integrators/integrator.h"
#include "core/integrators/light_pass.h"
#include "core/integrators/shadow.h"
#include "core/integrators/single_scatter.h"
#include "core/lights/lights.h"

#include <vector>

namespace abbe {

/// Global illumination by random paths from the camera [Kajiya86], per band, for whole bundles of
/// bands: one way on from each surface, two where the camera sees glass by glass and mirrors alone;
/// lamps aimed at wherever light is spread, both ways of reaching a lamp weighed against each other
/// [Veach97], and paths that carry little ended at random. Unbiased at a fixed number of samples.
///
/// With light-side passes, light that reaches a spreading surface through glass or by mirrors comes
/// from the photon map, and camera paths leave it out; see docs/decisions/caustics.md.
class Path final : public CameraIntegrator, private BundleWalk {
public:
  /// Keeps references to all. `light_passes` is null where there are none.
  Path(const Plan& plan, const World& world, const Lights& lamps, const LightPasses* light_passes,
       double pixel_angle);

  void trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
             RayCounts& counts) override;

private:
  /// Follows the current bundle to its end; sub-bundles that part from it wait.
  void follow();
  /// Adds what the bundle sees by itself: the background, or light that a surface emits.
  void gather();
  /// Makes the bundle go on from its hit. False where it ends.
  bool go_on();
  [[nodiscard]] Scattering::Choice branch();
  void aim_at_a_lamp(const Hit& hit);
  void look_up_photons(const Hit& hit);
  [[nodiscard]] bool found_otherwise(const Hit& emitting) const;
  [[nodiscard]] bool splatted() const;
  /// True after a surface that spreads light and then at least one that mirrors or refracts.
  [[nodiscard]] bool comes_by_mirrors_and_glass() const;

  const Lights& lamps_;
  const PhotonMap* photons_;
  const Emission* emission_;
  bool found_otherwise_; ///< whether light by mirrors and glass from lamps is
  ShadowRays shadow_rays_;
  SingleScatter single_scatter_;
  RadianceSums* sums_ = nullptr;
  std::vector<float> light_; ///< scratch: what one source gives
};

} // namespace abbe
