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
  /// Runs the current pass within the current task arena, unless the map holds its photons already.
  /// Splats that the film has already, because an earlier run was stopped or its map is gone, are
  /// not added again, and the rays that led to them not counted again. Where `is_over` says so, the
  /// run ends soon, also within a path; then the map does not hold the pass.
  RayCounts run(LightPassState& state, Film& film, const IsOver& is_over, RayRecord* record);

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
  [[nodiscard]] Followed follow_chunks(const Paths& paths, LightPassState& state, Film& film,
                                       const IsOver& is_over, RayRecord* record) const;

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
