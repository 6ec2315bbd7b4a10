#pragma once

#include "core/bundles/statistics.h"

#include <span>

namespace abbe {

/// How far a rendering has come.
struct RenderProgress {
  double fraction = 0.0; ///< of the samples that were asked for
  double seconds = 0.0;  ///< since the start
  RayCounts rays;
  bool light_paths = false; ///< light paths are followed now, and no camera samples taken
};

/// How far processes that have about as much to do have come together, by the clock of the first.
[[nodiscard]] RenderProgress together(std::span<const RenderProgress> processes);

} // namespace abbe
