#pragma once

#include "core/adaptive/render_part.h"
#include "core/adaptive/sample_schedule.h"
#include "core/bundles/statistics.h"
#include "core/cameras/placed_camera.h"
#include "core/film/film.h"
#include "core/integrators/end_check.h"
#include "core/integrators/photon_map.h"
#include "core/lights/emission.h"

#include <cstdint>
#include <vector>

namespace abbe {

class LightPaths;

/// Where the splats of a chunk of light paths are.
enum class ChunkSplats : std::uint8_t {
  missing,   ///< nowhere yet
  added,     ///< in the film
  elsewhere, ///< another part of the rendering adds them to its own film
};

/// How far the light passes of a rendering have come. With the film it is all that is needed to go
/// on: the same paths fill the photon map anew.
struct LightPassState {
  int passes = 0;                   ///< that have begun
  SampleRange samples;              ///< camera samples that the current pass is for
  SampleRange first_samples;        ///< those that the first pass was for
  std::vector<std::uint32_t> begun; ///< by light: paths of the passes before the current one
  std::vector<ChunkSplats> chunks;  ///< by chunk of the current pass
  double first_radius = 0.0;        ///< of the photon map in the first pass; 0: not known yet
  RenderPart part = {}; ///< light paths that only splat are divided as camera samples are
};

/// The light passes whose splats are in the film of a rendering that is no part, counted as the
/// film counts them.
[[nodiscard]] double light_passes_in_film(const LightPassState& state);

/// Of `count` films into which a light pass is divided, the one of this number gets the splats of
/// each chunk with that remainder. Photons are in the maps of all.
struct ChunkShare {
  std::size_t number = 0, count = 1;

  [[nodiscard]] bool has(std::size_t chunk) const { return chunk % count == number; }
};

/// Light-side passes of a rendering: before each pass of camera samples as many light paths are
/// followed as the plan says; they add splats to the film and fill the photon map anew.
class LightPasses {
public:
  /// Keeps references. `camera` is null where it cannot be connected with; camera paths then look
  /// up photons where light paths would have been splatted.
  LightPasses(const Scene& scene, const Plan& plan, const World& world, const PlacedCamera* camera);

  /// True when there is something to do; then `map` and `emission` are what camera paths need.
  [[nodiscard]] bool needed() const { return !emission_.lights().empty(); }
  [[nodiscard]] const PhotonMap& map() const { return map_; }
  [[nodiscard]] const Emission& emission() const { return emission_; }
  /// How long the passes have taken.
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Ends the current pass, if there is one, and begins the next, for these camera samples.
  void begin(LightPassState& state, SampleRange samples) const;
  // Splats that the film has already, because an earlier run was stopped or its map is gone, are
  // not added again, and the rays that led to them not counted again. Where `is_over` says so, a
  // run ends soon, also within a path. Where splats are shared among films, the passes of this one
  // are not counted. To be called within a task arena.

  /// What runs have in common.
  struct Run {
    Film& film;
    const IsOver& is_over;
    RayRecord* record = nullptr;
    ChunkShare share = {};
  };
  /// Follows the current pass's paths that fill the map, unless the map holds their photons
  /// already. When it is stopped the map does not hold the pass.
  RayCounts fill_map(LightPassState& state, const Run& run);
  /// Follows its paths that are splatted and nothing else, which camera paths need not wait for.
  RayCounts add_splats(LightPassState& state, const Run& run);
  /// True when the map holds the photons of the current pass.
  [[nodiscard]] bool has_map(const LightPassState& state) const {
    return mapped_pass_ == state.passes;
  }

private:
  /// Finds the radius of the first pass's photon map for a part of the rendering that begins after
  /// that pass. False when it was stopped.
  bool find_first_radius(LightPassState& state, const IsOver& is_over) const;

  /// A run of one light's paths, which one task follows.
  struct Chunk {
    std::size_t light;
    std::uint32_t first, last; ///< numbers among the light's paths of this pass
  };
  /// The paths of one pass.
  struct Paths {
    std::vector<std::uint32_t> shares; ///< by light: how many begin there
    std::vector<std::uint32_t> mapped; ///< by light: how many of these fill the map
    std::vector<Chunk> chunks;
  };
  [[nodiscard]] Paths paths_of(SampleRange samples) const;
  /// Where what a chunk's paths find goes, beside their splats.
  struct Found {
    PhotonBatch& photons;
    RayCounts& counts;
  };
  /// Follows a chunk's paths. `begun` of the light's paths belong to earlier passes. False where
  /// they were given up.
  bool follow(LightPaths& walker, const Chunk& chunk, const Paths& paths, std::uint32_t begun,
              const Found& found) const;
  /// What all chunks have found, in their order.
  struct Followed {
    std::vector<PhotonBatch> batches;
    RayCounts rays;
    bool all; ///< none was left out by a stop
  };
  /// Which of the paths a run follows.
  enum class Which { that_fill_the_map, that_only_splat };
  [[nodiscard]] Followed follow_chunks(const Paths& paths, Which which, LightPassState& state,
                                       const Run& run) const;
  /// The same, and counts the passes of the film.
  [[nodiscard]] Followed follow_and_count(const Paths& paths, Which which, LightPassState& state,
                                          const Run& run) const;

  const Plan& plan_;
  const World& world_;
  const PlacedCamera* camera_;
  Emission emission_;
  PhotonMap map_;
  double largest_radius_;
  int mapped_pass_ = 0; ///< the number, from 1, of the pass whose photons the map holds
  double seconds_ = 0.0;
};

} // namespace abbe
