#pragma once

#include "core/integrators/integrator.h"
#include "core/integrators/light_pass.h"
#include "core/integrators/random_walk.h"
#include "core/integrators/shadow.h"
#include "core/integrators/single_scatter.h"
#include "core/integrators/sky_view.h"
#include "core/lights/lights.h"

#include <vector>

namespace abbe {

/// Global illumination by random paths from the camera [Kajiya86], per band, for whole bundles of
/// bands. A path goes on along one direction from each surface, and along two where the camera sees
/// glass through glass and mirrors alone. Wherever a surface scatters light other than specularly a
/// light is sampled, and both techniques of reaching it are weighed against each other [Veach97].
/// Paths that carry little are ended at random. At a fixed number of samples the image is unbiased.
///
/// With light-side passes, light that reaches such a surface through glass or by mirrors comes from
/// the photon map, and camera paths leave it out; see docs/decisions/caustics.md.
class Path final : public CameraIntegrator, private RandomWalk {
public:
  /// Keeps references to all. `light_passes` is null where there are none.
  Path(const Plan& plan, const World& world, const Lights& lights, const LightPasses* light_passes,
       double pixel_angle);

  bool trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
             RayCounts& counts) override;

private:
  /// Adds the light of the traced bundle's ray. What goes on from its hit waits.
  void shade();
  /// Adds what the bundle sees by itself: the background, or light that a surface emits.
  void gather();
  /// Adds what lights and photons bring to the bundle's hit, and lets what goes on from there wait.
  void go_on();
  /// The same where the path has met as many surfaces as it may.
  void look_through();
  void go_on_beyond();
  template <class Step>
  void aside(Step&& step);
  [[nodiscard]] Scattering::Choice branch();
  void sample_light(const Hit& hit);
  void look_up_photons(const Hit& hit);
  [[nodiscard]] Arrival arrival_of_seen() const;
  [[nodiscard]] Arrival arrival_here(bool straight) const;
  [[nodiscard]] bool found_otherwise(const Hit& emitting) const;
  [[nodiscard]] bool splatted() const;
  /// True after a surface that scatters other than specularly and then at least one that mirrors or
  /// refracts.
  [[nodiscard]] bool comes_by_mirrors_and_glass() const;

  const Lights& lights_;
  const PhotonMap* photons_;
  const Emission* emission_;
  bool found_otherwise_; ///< whether light paths or shadow rays find light by mirrors and glass
  ShadowRays shadow_rays_;
  SingleScatter single_scatter_;
  SkyView sky_;
  RadianceSums* sums_ = nullptr;
  std::vector<float> light_; ///< scratch: what one source gives
  std::vector<float> kept_;  ///< scratch: a throughput that is needed again
};

} // namespace abbe
