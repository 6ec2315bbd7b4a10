#pragma once

#include "core/render/render.h"

#include <chrono>
#include <mutex>

namespace abbe {

/// Sums what threads have rendered and tells about it at most ten times a second. Work is counted
/// in camera samples.
class ProgressMeter {
public:
  /// `expected` work may turn out otherwise. With a time limit (not 0) its end counts as well.
  ProgressMeter(const ProgressCallback& callback, double expected, double time_limit);

  /// Tells that work was done, and by how much that changed what is expected in all.
  void step(const RayCounts& rays, double done, double expected_more);

  /// Counts rays that are no camera sample's work.
  void add(const RayCounts& rays);

  /// Tells that light paths are followed. Any number of threads may call it at once, and often.
  void follow_light();

  [[nodiscard]] double seconds() const;
  /// The rays that were counted since it was asked for them before.
  [[nodiscard]] RayCounts take_rays();

private:
  const ProgressCallback& callback_;
  double expected_, time_limit_;
  double done_ = 0.0;
  double fraction_ = 0.0;
  double told_ = 0.0; ///< when
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  RayCounts rays_;  ///< all
  RayCounts since_; ///< since they were taken
  std::mutex mutex_;
};

} // namespace abbe
