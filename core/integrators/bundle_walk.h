#pragma once

#include "core/bands/band_table.h"
#include "core/bundles/extend.h"
#include "core/bundles/fan.h"
#include "core/bundles/waiting_bundles.h"
#include "core/optics/transport.h"

#include <glm/vec2.hpp>

#include <memory>

namespace abbe {

using glm::dvec2;

/// What all paths through a scene have in common, those of both integrators and those of light: one
/// current bundle, others that wait, and the specular steps from a surface to the next.
///
/// A path is `while (take()) { extend(); ... }`, where the dots shade: they may let bundles wait,
/// the current one among them. See core/bundles/extend.h.
class BundleWalk {
protected:
  /// Keeps references. `pixel_angle` is that of Fan.
  BundleWalk(const Plan& plan, const World& world, double pixel_angle, Transport transport);

  /// Starts a path. Of `wavelength`, x is the place inside the bands and y the roulette's number.
  void begin_path(const dvec2& wavelength, RayCounts& counts);

  [[nodiscard]] Bundle& bundle() { return carried_->bundle; }
  [[nodiscard]] const Bundle& bundle() const { return carried_->bundle; }
  [[nodiscard]] BandSpan<float> throughput() { return carried_->throughput(); }
  /// Multiplies the throughput by factors per band and a weight.
  void scale(const float* factors, double weight);

  /// Takes up the bundle that came last to wait. False when none waits.
  [[nodiscard]] bool take() { return waiting_.take(carried_); }
  /// Leaves the path as it is.
  void give_up() { waiting_.clear(); }
  /// Finds what the bundle's ray meets.
  void extend() { abbe::extend(bundle(), world_, *counts_); }
  /// The bundle waits for its next turn. Until then there is no current one.
  void wait() { waiting_.put(carried_); }

  /// A new bundle of these bands that waits; its throughput is the current one times factors per
  /// band and a weight. All but its bands is the caller's to fill.
  [[nodiscard]] Bundle& branch_off(BandRange bands, const float* factors, double weight);
  /// The same, along the reflected ray of the current bundle's hit. Its route is that of a surface
  /// that also lets light through.
  Bundle& branch_off_reflection(const float* factors, double weight);
  /// Sub-bundles that are refracted at the current bundle's hit wait; the current throughput is
  /// already what passes. Bands of `run` have some; `importance` is what they bring to the image.
  void branch_off_refraction(BandRange run, double importance);

  [[nodiscard]] dvec3 reflected_direction() const;
  /// The factor on flux that goes along it; 1 for radiance.
  [[nodiscard]] double reflected_adjoint() const;

  /// How much of what they meet in a medium bands bring to the image, when `most` is the largest
  /// throughput among them and `first` the first of them.
  [[nodiscard]] double importance(float most, int first, MediumId medium);
  /// The same for the current bundle.
  [[nodiscard]] double importance(MediumId medium);
  /// What bands of this importance bring of the image's light, up to 1 for all: see BandShares.
  [[nodiscard]] double share(double importance, BandRange bands) const {
    return importance * plan_.shares.of(bands);
  }

  const Plan& plan_;
  const World& world_;
  PathWavelengths wavelengths_;
  BandTable ones_;
  RayCounts* counts_ = nullptr;

private:
  Transport transport_;
  Fan fan_;
  double band_choice_ = 0.0;
  WaitingBundles waiting_;
  std::unique_ptr<CarriedBundle> carried_; ///< the current bundle
};

} // namespace abbe
