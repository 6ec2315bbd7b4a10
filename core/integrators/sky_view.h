#pragma once

#include "core/bundles/bundle.h"
#include "core/lights/lights.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace abbe {

/// What camera paths see that leave the scene: the sky itself, and how much of it shows through the
/// scene, which becomes alpha. One object serves one thread.
///
/// A path *passes* to the sky when it leaves within 90 degrees of its camera ray and has come there
/// through surfaces that let light through, bent by them or not, or past all. What they reflect
/// among them passes too, as it does in a slab. All other paths to the sky are reflections, which
/// belong to the surface that they come from.
class SkyView {
public:
  /// Keeps references to both.
  SkyView(const Plan& plan, const Lights& lights) : plan_(plan), lights_(lights) {}

  /// Starts a path with its ray from the camera.
  void begin_path(const dvec3& camera_direction) { camera_direction_ = camera_direction; }

  /// Adds what a path sees by a ray that meets nothing. `left_out` is that of Lights::add_sky. The
  /// path ends there: its throughput is changed.
  void add(const Bundle& bundle, Lights::LeftOut left_out, BandSpan<float> throughput,
           RadianceSums& sums) const;

  /// True for light of the sky that the picture leaves out since its path passes: the light of a
  /// sample, which comes to a path on this route from there.
  [[nodiscard]] bool leaves_out(Route route, const LightSample& sample) const {
    return plan_.sky.transparent && sample.pdf > 0.0 && std::isinf(sample.distance) &&
           passes(route, sample.direction);
  }

private:
  [[nodiscard]] bool passes(Route route, const dvec3& direction) const {
    return (route == Route::direct || route == Route::through) &&
           glm::dot(direction, camera_direction_) > 0.0;
  }

  const Plan& plan_;
  const Lights& lights_;
  dvec3 camera_direction_{0.0};
};

} // namespace abbe
