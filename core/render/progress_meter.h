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

  [[nodiscard]] double seconds() const;
  [[nodiscard]] const RayCounts& rays() const { return rays_; }

private:
  const ProgressCallback& callback_;
  double expected_, time_limit_;
  double done_ = 0.0;
  double fraction_ = 0.0;
  double told_ = 0.0; ///< when
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  RayCounts rays_;
  std::mutex mutex_;
};

} // namespace abbe
