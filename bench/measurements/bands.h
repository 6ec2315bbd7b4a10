#pragma once

#include "bench/measurements/setup.h"
#include "bench/measurements/timing.h"

namespace abbe::bench {

struct BandCost {
  int bands = 0;
  Summary render_seconds; ///< processor time, summed over the threads
  Summary wall_seconds;
  RayCounts counts;
};

/// What more bands cost in one scene.
struct BandCosts {
  std::string scene;
  RenderSettings settings; ///< of the last of `costs`
  std::vector<BandCost> costs;
};

/// The thesis's levels: 1, 3, 9, 27 and 81 bands.
[[nodiscard]] BandCosts measure_bands(const std::filesystem::path& scene,
                                      const RenderOptions& options);

} // namespace abbe::bench
