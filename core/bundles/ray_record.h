#pragma once

#include "geometry/rays/ray_state.h"

#include <cstdint>
#include <vector>

namespace abbe {

/// What sends a ray. `scattered`: a surface that scatters light other than specularly. `light`: a
/// light.
enum class RayKind : std::uint8_t { camera, reflected, refracted, scattered, shadow, light };

/// The rays of a rendering in the order in which they were traced, for measurements. It grows by
/// some 150 bytes a ray and is no place for two threads at once.
struct RayRecord {
  /// A run of rays of one kind that were handed to the world together or one after the other.
  struct Run {
    RayKind kind;
    bool any_hit;      ///< asked only whether something lies before that distance, not what
    std::size_t count; ///< how many rays of `states` and `distances` belong to it
  };
  std::vector<Run> runs;
  std::vector<RayState> states;
  std::vector<double> distances; ///< how far the ray looks

  void add(RayKind kind, const RayState& state, double distance, bool any_hit) {
    if (runs.empty() || runs.back().kind != kind || runs.back().any_hit != any_hit)
      runs.push_back({kind, any_hit, 0});
    ++runs.back().count;
    states.push_back(state);
    distances.push_back(distance);
  }
};

} // namespace abbe
