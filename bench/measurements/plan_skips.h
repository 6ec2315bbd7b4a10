#pragma once

#include "bench/measurements/setup.h"
#include "bench/measurements/timing.h"

namespace abbe::bench {

/// A rendering without something that the plan would skip.
struct SkipCost {
  std::string without; ///< a member of Skips in words, "all skips", or "nothing"
  Skips skip;
  Summary render_seconds; ///< processor time, summed over the threads
  Summary wall_seconds;
  Summary ratio;                  ///< seconds over those with all skips, round by round
  std::size_t changed_pixels = 0; ///< whose colour or bands differ by a bit
};

/// What each thing that the plan skips is worth in one scene.
struct SkipCosts {
  std::string scene;
  RenderSettings settings;
  std::size_t tiles = 0, empty_tiles = 0;
  int dead_bands = 0;
  std::vector<SkipCost> costs; ///< nothing left out of the skips comes first, all of them last

  [[nodiscard]] bool changed() const; ///< some pixel did
};

[[nodiscard]] SkipCosts measure_plan(const std::filesystem::path& scene,
                                     const RenderOptions& options);

} // namespace abbe::bench
