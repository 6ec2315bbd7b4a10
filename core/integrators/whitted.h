#pragma once

#include "core/integrators/bundle_walk.h"
#include "core/integrators/integrator.h"
#include "core/integrators/shadow.h"
#include "core/integrators/single_scatter.h"
#include "core/integrators/sky_view.h"
#include "core/lights/lights.h"
#include "core/sampling/sampler.h"

#include <vector>

namespace abbe {

/// The thesis's model of light [War05, 4.6; Whitted80], per band: ambient, emitted, Lambert and
/// Phong (with Blinn's half vector) light of the lights, and the trees of reflected and refracted
/// rays.
class Whitted final : public CameraIntegrator, private BundleWalk {
public:
  /// Keeps references to all.
  Whitted(const Scene& scene, const Plan& plan, const World& world, const Lights& lights,
          double pixel_angle);

  bool trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
             RayCounts& counts) override;

private:
  /// Bundle number `i` of the sample waits to be followed.
  void start(const CameraPaths& paths, std::size_t i);
  /// Adds the light of the traced bundle's ray. What goes on from its hit waits.
  void shade_ray(RadianceSums& sums, RayCounts& counts);
  void shade(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
             RayCounts& counts);
  [[nodiscard]] BandSpan<const float> diffuse_under_coat(const Bundle& bundle,
                                                         const MaterialPlan& material,
                                                         const BandTable& diffuse, double cos_o,
                                                         double cos_i);
  void add_lights(const Bundle& bundle, const MaterialPlan& material, RadianceSums& sums,
                  RayCounts& counts);
  void scatter(const Bundle& bundle, const MaterialPlan& material);
  void reflect();
  void send_back(double weight);
  void refract();
  void pass();
  void go_straight_on(double weight);
  void choose_branches(const BsdfFacts& facts);
  void go_on(const BsdfFacts& facts);
  template <class Step>
  void aside(Step&& step);
  [[nodiscard]] double brought(const float* factors, MediumId medium);
  [[nodiscard]] double faint_chance(double importance) const;
  [[nodiscard]] double chance(double importance) const;
  [[nodiscard]] double deep_chance(double importance) const;

  const Scene& scene_;
  ShadowRays shadow_rays_;
  SingleScatter single_scatter_;
  SkyView sky_;
  std::vector<float> reflected_, transmitted_; ///< factors of the surface being shaded
  bool lets_light_through_ = false;            ///< the surface being shaded
  BandTable textured_;
  DecisionStream decisions_;

  std::vector<float> lit_;    ///< the throughput after a shadow ray
  std::vector<float> coated_; ///< the same after a coat, there and back
};

} // namespace abbe
