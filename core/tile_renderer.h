#pragma once

#include "core/camera.h"
#include "core/film.h"
#include "core/integrators/integrator.h"
#include "core/light_pass.h"
#include "core/lights/lamps.h"
#include "core/plan.h"
#include "core/radiance_sums.h"
#include "core/sampler.h"
#include "core/statistics.h"
#include "geometry/world.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace abbe {

/// Which samples of each pixel are to be rendered: [first, last).
struct SampleRange {
  int first, last;
};

/// Renders tiles on one thread.
class TileRenderer {
public:
  /// Keeps references to all; `light_passes` is null where there are none.
  TileRenderer(const Scene& scene, const Plan& plan, const World& world, const Lamps& lamps,
               const LightPasses* light_passes, const CameraRays& camera,
               const Nesting& camera_nesting, Film& film);

  /// Adds the samples of every pixel of the tile to the film.
  RayCounts render(const Tile& tile, SampleRange samples, RayRecord* record);

private:
  static constexpr std::size_t kPacketWidth = 16;

  struct CameraSample {
    int x, y;
    Sampler sampler;
  };

  void finish_batch(bool empty, RayCounts& counts);

  const Plan& plan_;
  const World& world_;
  const CameraRays& camera_;
  const Nesting& camera_nesting_;
  Film& film_;
  std::unique_ptr<CameraIntegrator> integrator_;
  RadianceSums sums_;
  std::vector<CameraSample> batch_;
  std::array<RayState, kPacketWidth> states_;
  std::array<std::optional<Hit>, kPacketWidth> hits_;
};

} // namespace abbe
