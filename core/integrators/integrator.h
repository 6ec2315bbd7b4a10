#pragma once

#include "core/bundles/bundle.h"
#include "core/bundles/statistics.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/beyond_limit.h"
#include "core/integrators/end_check.h"
#include "core/sampling/sampler.h"

namespace abbe {

/// Finds the light that camera rays see. One object serves one thread; it keeps the memory of its
/// paths.
class CameraIntegrator {
public:
  explicit CameraIntegrator(const Plan& plan) : beyond_(plan) {}
  CameraIntegrator(const CameraIntegrator&) = delete;
  CameraIntegrator& operator=(const CameraIntegrator&) = delete;
  virtual ~CameraIntegrator() = default;

  /// Follows the bundles of one camera sample and adds what they see to `sums`. Returns false where
  /// it gave up, since the rendering is to end; then the sample is of no use.
  virtual bool trace(const CameraPaths& start, const Sampler& sampler, RadianceSums& sums,
                     RayCounts& counts) = 0;

  /// What the last sample would have brought from beyond the depth limit.
  [[nodiscard]] const BeyondLimit& beyond() const { return beyond_; }
  /// Long paths ask this now and then. Keeps a reference.
  void end_with(const IsOver& is_over) { end_check_.end_with(is_over); }

protected:
  EndCheck end_check_;
  BeyondLimit beyond_;
};

} // namespace abbe
