#pragma once

#include "core/radiance_sums.h"
#include "core/sampler.h"
#include "core/statistics.h"
#include "geometry/ray_state.h"

#include <optional>

namespace abbe {

/// Finds the light that camera rays see. One object serves one thread; it keeps the memory of its
/// paths.
class CameraIntegrator {
public:
  CameraIntegrator() = default;
  CameraIntegrator(const CameraIntegrator&) = delete;
  CameraIntegrator& operator=(const CameraIntegrator&) = delete;
  virtual ~CameraIntegrator() = default;

  /// Follows a camera ray that has been traced to `hit` and adds what it sees to `sums`.
  virtual void trace(const RayState& camera_ray, const std::optional<Hit>& hit,
                     const Sampler& sampler, RadianceSums& sums, RayCounts& counts) = 0;
};

} // namespace abbe
