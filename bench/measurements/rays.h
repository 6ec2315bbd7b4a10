#pragma once

#include "bench/measurements/replay.h"
#include "bench/measurements/setup.h"
#include "bench/measurements/timing.h"

namespace abbe::bench {

/// How fast the rays of one kind go.
struct KindSpeed {
  RayKind kind = RayKind::camera;
  std::size_t rays = 0;
  std::array<Summary, kPacketWidths.size()> replay_seconds; ///< raw Embree, by packet width
  Summary query_seconds; ///< the world's queries, as the renderer asks them
  bool any_hit = false;  ///< only whether something is in the way; these go one at a time

  [[nodiscard]] const Summary& best_replay() const; ///< of the packet width that is fastest
  [[nodiscard]] double best_replay_seconds() const { return best_replay().median; }
  [[nodiscard]] int best_width() const;
};

/// The rays of one rendering, and the same rays through raw Embree. All times are seconds of
/// processor time summed over the threads, medians of interleaved repeats.
struct RaySpeed {
  std::string scene;
  RenderSettings settings;
  Summary render_seconds, render_wall_seconds;
  RayCounts counts;
  std::vector<KindSpeed> kinds;

  /// Raw Embree's time for all rays over the rendering's: 1 would be a rendering that does nothing
  /// but trace, without any cost.
  [[nodiscard]] double ratio() const;
  // Times of all kinds of rays.
  [[nodiscard]] double best_replay_seconds() const;
  [[nodiscard]] double single_replay_seconds() const;
  [[nodiscard]] double query_seconds() const;
};

[[nodiscard]] RaySpeed measure_rays(const std::filesystem::path& scene,
                                    const RenderOptions& options);

} // namespace abbe::bench
