#pragma once

#include "core/bundles/statistics.h"
#include "core/film/radiance_sums.h"
#include "core/sampling/sampler.h"

#include <limits>

namespace abbe {

/// How often a path may be reflected or refracted.
[[nodiscard]] inline int depth_limit(const RenderSettings& settings) {
  return settings.max_depth < kNoDepthLimit ? settings.max_depth : std::numeric_limits<int>::max();
}

/// What a limit of depth takes from the image, estimated. One in `kOneIn` of the paths that the
/// limit ends is followed on, and what it brings stands for all of them. Nothing of it reaches the
/// image: its light, its rays and its random decisions are kept apart.
struct BeyondLimit {
  static constexpr double kOneIn = 64.0;

  explicit BeyondLimit(const Plan& plan) : limit(depth_limit(plan.settings)), sums(plan) {}

  void begin_path(const Sampler& sampler) {
    if (limit == std::numeric_limits<int>::max()) return;
    sums.clear();
    decisions = sampler.decisions(1);
  }
  /// Whether a path that the limit ends goes on.
  [[nodiscard]] bool chosen() { return decisions.next() * kOneIn < 1.0; }
  /// How bright what the path would have brought is, in the mean.
  [[nodiscard]] double luminance() const { return kOneIn * sums.color().y; }

  int limit;
  RadianceSums sums;
  RayCounts rays;
  DecisionStream decisions;
};

} // namespace abbe
