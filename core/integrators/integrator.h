#pragma once

#include "core/bundles/bundle.h"
#include "core/bundles/statistics.h"
#include "core/film/radiance_sums.h"
#include "core/sampling/sampler.h"

namespace abbe {

/// Finds the light that camera rays see. One object serves one thread; it keeps the memory of its
/// paths.
class CameraIntegrator {
public:
  CameraIntegrator() = default;
  CameraIntegrator(const CameraIntegrator&) = delete;
  CameraIntegrator& operator=(const CameraIntegrator&) = delete;
  virtual ~CameraIntegrator() = default;

  /// Follows the bundles of one camera sample and adds what they see to `sums`.
  virtual void trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
                     RayCounts& counts) = 0;
};

} // namespace abbe
