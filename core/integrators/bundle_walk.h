#pragma once

#include "core/bundles/fan.h"
#include "core/sampling/sampler.h"
#include "core/scattering/scattering.h"

#include <vector>

namespace abbe {

/// What camera paths and light paths have in common: a bundle on its way, others that wait, and
/// the steps from surface to surface.
class BundleWalk {
protected:
  /// Keeps references. `pixel_angle` is that of Fan.
  BundleWalk(const Plan& plan, const World& world, double pixel_angle, Transport transport);

  /// Starts a sample. The random numbers of its steps come from `sampler`.
  void begin(const Sampler& sampler, RayCounts& counts);
  /// Two numbers in [0, 1) for a purpose at the surface that the bundle has met.
  [[nodiscard]] dvec2 numbers(SamplePurpose purpose) const;

  /// Room for a bundle of bands [first, last) that waits for its turn, with the current throughput
  /// times factors per band and a weight. All but its bands is the caller's to fill; what was there
  /// before is of no use.
  [[nodiscard]] Bundle& push(int first, int last, const float* factors, double weight);
  /// Takes up the bundle that was pushed last. False when none waits.
  bool resume();

  /// Multiplies the throughput by factors per band and a weight.
  void scale(const float* factors, double weight);

  /// The material at the bundle's hit; of a mixture one of its parts, chosen at random.
  const MaterialPlan& find_material();
  /// Prepares scattering_ for the bundle's hit on the material that was found there last.
  void prepare_scattering();

  // Steps from the bundle's hit; scattering_ has been prepared for it. False where the path ends.
  bool reflect(double chance);
  bool refract(double chance);
  /// The reflected ray is traced and waits; the bundle itself stays where it is.
  void branch_off_reflection(double chance);
  /// Along a direction to which the surface spreads light, with the factors and the density that
  /// Scattering gave for it; `weight` makes up for another chance of getting here.
  bool spread(const dvec3& direction, const float* f_cos, double density, double weight);

  const Plan& plan_;
  const World& world_;
  PathWavelengths wavelengths_;
  Fan fan_;
  Scattering scattering_;
  BandTable ones_;
  RayCounts* counts_ = nullptr;

  Bundle bundle_;                 ///< on its way
  std::vector<float> throughput_; ///< of it

  /// As set_off, and traced.
  void trace_from(const Bundle& from, const dvec3& direction, bool through, RayKind kind,
                  Bundle& next);
  /// What the bundle would bring of the picture's light in a medium, up to 1 for all bands: see
  /// BandShares.
  [[nodiscard]] double share(MediumId medium);

private:
  [[nodiscard]] dvec3 reflected_direction() const;
  bool leave(const dvec3& direction, bool through, RayKind kind);
  [[nodiscard]] double importance(MediumId medium);
  bool survives(MediumId medium);

  Transport transport_;
  BandTable textured_; ///< scratch: the diffuse reflectance at the hit
  const MaterialPlan* material_ = nullptr;
  const Sampler* sampler_ = nullptr;
  double band_choice_ = 0.0;
  std::size_t waiting_count_ = 0;
  std::vector<Bundle> waiting_;    ///< the first so many wait; the others are room for more
  std::vector<float> throughputs_; ///< rows of Plan::stride values, one per waiting bundle
};

} // namespace abbe
