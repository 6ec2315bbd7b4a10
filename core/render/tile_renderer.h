#pragma once

#include "core/adaptive/sample_schedule.h"
#include "core/bundles/statistics.h"
#include "core/film/film.h"
#include "core/film/radiance_sums.h"
#include "core/integrators/integrator.h"
#include "core/integrators/light_pass.h"
#include "core/lights/lights.h"
#include "core/plan/plan.h"
#include "core/render/camera_start.h"
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

  [[nodiscard]] SampleRange of(const Film& film, int x, int y) const;

private:
  SampleRange all_;
  std::span<const std::uint32_t> allocation_; ///< empty for `all_`
  int passes_left_ = 1;
};

/// Renders tiles on one thread.
class TileRenderer {
public:
  /// Keeps references to all. `pixel_rays`, unless it is empty, counts the rays of each pixel of
  /// the film, row by row.
  TileRenderer(const RenderContext& context, Film& film, std::span<std::uint32_t> pixel_rays);

  /// Adds the samples of every pixel of the tile to the film, and their number to `rendered`.
  RayCounts render(const Tile& tile, const PassSamples& samples, RayRecord* record,
                   std::uint64_t& rendered);

private:
  static constexpr std::size_t kPacketWidth = 16;

  struct CameraSample {
    int x, y;
    std::uint32_t index; ///< of the pixel's samples
    Sampler sampler;
  };

  [[nodiscard]] dvec2 film_position(const CameraSample& sample) const;
  void finish_batch(bool empty, RayCounts& counts);
  void trace_sample(const CameraSample& sample, const CameraPaths& start, RayCounts& counts);

  const Plan& plan_;
  const World& world_;
  Film& film_;
  std::optional<LayerId> transparency_, transmittance_;
  std::span<std::uint32_t> pixel_rays_;
  std::unique_ptr<CameraIntegrator> integrator_;
  RadianceSums sums_;
  std::optional<LayerId> evidence_;
  std::vector<CameraSample> batch_;
  CameraStart start_;
  std::vector<Hit> hits_; ///< of the batch's rays
};

} // namespace abbe
