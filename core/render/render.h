#pragma once

#include "core/bundles/statistics.h"
#include "core/film/film.h"
#include "core/plan/plan.h"
#include "geometry/world.h"

#include <atomic>
#include <functional>
#include <utility>

namespace abbe {

/// How far a rendering has come.
struct RenderProgress {
  double fraction = 0.0; ///< of all samples
  double seconds = 0.0;  ///< since the start
  RayCounts rays;
};

/// Called now and then by one of the rendering threads, never by two at once.
using ProgressCallback = std::function<void(const RenderProgress&)>;

struct Rendering {
  Film film;
  RayCounts rays = {};
  double seconds = 0.0;
  double light_seconds = 0.0; ///< of these, in light-side passes
  bool complete = true;       ///< false when it was stopped; not when its time was up
  std::size_t open_tiles = 0; ///< that did not reach `RenderSettings::noise`
};

/// Whether the film keeps every band besides XYZ, and where.
struct KeepBands {
  KeepBands(bool yes) : keep(yes) {} // NOLINT: render(..., false, ...) says enough
  explicit KeepBands(BandPlace where) : keep(true), place(std::move(where)) {}

  bool keep;
  BandPlace place = {};
};

/// Renders the planned window: every pixel with all samples, or each tile until its noise or all of
/// it until its time says enough, see `RenderSettings`. The film keeps errors where the settings
/// need or ask for them. Setting `stop` from anywhere ends the rendering soon; what is done is
/// returned. `record`, for measurements, gets all rays; it needs settings with one thread.
[[nodiscard]] Rendering render(const Scene& scene, const Plan& plan, const World& world,
                               const KeepBands& bands, const ProgressCallback& progress,
                               const std::atomic<bool>& stop, RayRecord* record = nullptr);

} // namespace abbe
