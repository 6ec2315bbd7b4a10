#pragma once

#include "core/adaptive/sample_schedule.h"
#include "core/bundles/statistics.h"
#include "core/film/film.h"
#include "core/film/part_layers.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/integrator.h"
#include "core/integrators/light_pass.h"
#include "core/lights/lights.h"
#include "core/plan/plan.h"
#include "core/render/camera_start.h"
#include "core/render/first_hit.h"
#include "core/render/render_state.h"
#include "core/sampling/sampler.h"
#include "geometry/world/world.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace abbe {

/// What all tiles of a rendering share. It keeps references, and others keep references to it.
struct RenderContext {
  const Scene& scene;
  const Plan& plan;
  const World& world;
  PlacedCamera camera;
  Lights lights;
  LightPasses light_passes;

  RenderContext(const Scene& the_scene, const Plan& the_plan, const World& the_world);
  RenderContext(const RenderContext&) = delete;
  RenderContext& operator=(const RenderContext&) = delete;
};

/// Which samples of each pixel one pass renders.
class PassSamples {
public:
  /// The same of all pixels.
  explicit PassSamples(SampleRange all) : all_(all) {}
  /// Those that bring pixels to a number of their own, row by row of the film's window, in
  /// `passes_left` passes that take equal parts. Keeps a reference.
  PassSamples(std::span<const std::uint32_t> allocation, int passes_left)
      : allocation_(allocation), passes_left_(passes_left) {}
  /// Of pixels that get numbers of their own, from the first to the last, the samples that are to
  /// all of them as the range is to `mean` samples. Keeps a reference.
  PassSamples(std::span<const std::uint32_t> allocation, SampleRange range, int mean)
      : all_(range), allocation_(allocation), mean_(mean) {}

  /// Those of a pixel of which so many are in the film already.
  [[nodiscard]] SampleRange of(const Film& film, int x, int y, int already = 0) const;

private:
  SampleRange all_;
  std::span<const std::uint32_t> allocation_; ///< empty for `all_`
  int passes_left_ = 1;
  int mean_ = 0; ///< 0: the samples depend on what pixels have
};

/// How far a pass of a tile has come.
struct PassProgress {
  std::uint64_t rendered = 0; ///< how many samples were added to the film
  RayCounts rays;
  bool whole = true; ///< false where it was given up
};

/// Renders tiles on one thread.
class TileRenderer {
public:
  /// Keeps references to all. `pixel_rays`, unless it is empty, counts the rays of each pixel of
  /// the film, row by row. Where `is_over` says so a tile is given up.
  TileRenderer(const RenderContext& context, Film& film, std::span<std::uint32_t> pixel_rays,
               const IsOver& is_over);

  /// Adds the samples of every pixel of the tile to the film, from where the pass was left before:
  /// `left` tells, and tells anew.
  PassProgress render(const Tile& tile, const PassSamples& samples, LeftPass& left,
                      RayRecord* record);

private:
  static constexpr std::size_t kPacketWidth = 16;

  struct CameraSample {
    int x, y;
    std::uint32_t index; ///< of the pixel's samples
    LeftPass behind;     ///< how far the pass has come with it
    Sampler sampler;
  };

  [[nodiscard]] dvec2 film_position(const CameraSample& sample) const;
  void finish_batch(bool empty, LeftPass& left, PassProgress& progress);
  [[nodiscard]] bool trace_sample(const CameraSample& sample, const CameraPaths& start,
                                  RayCounts& counts);

  const Plan& plan_;
  const World& world_;
  Film& film_;
  std::optional<LayerId> transparency_, transmittance_;
  std::span<std::uint32_t> pixel_rays_;
  std::unique_ptr<CameraIntegrator> integrator_;
  const IsOver& is_over_;
  RadianceSums sums_;
  std::optional<LayerId> evidence_;
  std::optional<LayerId> lost_;           ///< what a limit of depth takes
  std::optional<FirstHit> first_hit_;     ///< where its layers are asked for
  std::optional<PartLayers> part_layers_; ///< the same
  std::optional<RadianceParts> parts_;    ///< of the current sample, for these
  std::vector<CameraSample> batch_;
  CameraStart start_;
  std::vector<Hit> hits_; ///< of the batch's rays
};

} // namespace abbe
