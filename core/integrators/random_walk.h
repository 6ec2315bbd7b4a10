#pragma once

#include "core/integrators/bundle_walk.h"
#include "core/sampling/sampler.h"
#include "core/scattering/scattering.h"

namespace abbe {

/// What camera paths and light paths have in common where they go on at random: one direction from
/// each surface, chosen by what each would bring, and paths that carry little ended by Russian
/// roulette.
class RandomWalk : protected BundleWalk {
protected:
  /// Keeps references. `pixel_angle` is that of Fan.
  RandomWalk(const Plan& plan, const World& world, double pixel_angle, Transport transport);

  /// Starts a path. The random numbers of its steps come from `sampler`.
  void begin(const Sampler& sampler, RayCounts& counts);
  /// Two numbers in [0, 1) for a purpose at the surface that the bundle has met.
  [[nodiscard]] dvec2 numbers(SamplePurpose purpose) const;

  /// The material at the bundle's hit; of a mixture one of its parts, chosen at random.
  const MaterialPlan& find_material();
  /// Prepares scattering_ for the bundle's hit on the material that was found there last.
  void prepare_scattering();

  // Steps from the bundle's hit, for which scattering_ has been prepared. Where the path does not
  // end there, the bundle waits to go on, or sub-bundles of it do.
  void reflect(double chance);
  void refract(double chance);
  /// Straight on through a pane: for what comes later the path has met no surface.
  void pass(double chance);
  /// Goes on along a direction that Scattering has sampled, with the factors and the pdf that it
  /// gives for it; `weight` makes up for another chance of getting here.
  void scatter(const dvec3& direction, const float* f_cos, double pdf, double weight);

  /// Whether the material that was found last also lets light through.
  [[nodiscard]] bool clear() const {
    const BsdfFacts facts = material_->facts();
    return facts.transmits || facts.passes;
  }
  /// The route by which a path goes on from the bundle's hit.
  [[nodiscard]] Route route_on(bool through) const {
    return through ? let_through(bundle().route) : sent_back(bundle().route, clear());
  }

  Scattering scattering_;

private:
  bool survives(MediumId medium);
  void go_on(const dvec3& direction, bool through, RayKind kind, double pdf);

  BandTable textured_; ///< scratch: the diffuse reflectance at the hit
  const MaterialPlan* material_ = nullptr;
  const Sampler* sampler_ = nullptr;
};

} // namespace abbe
