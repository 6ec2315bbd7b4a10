#pragma once

#include "core/render/render_progress.h"
#include "core/render/render_state.h"
#include "geometry/world/world.h"

#include <atomic>
#include <functional>
#include <optional>

namespace abbe {

struct Peers;

/// Called now and then by one of the rendering threads, never by two at once.
using ProgressCallback = std::function<void(const RenderProgress&)>;

/// Who watches and ends a rendering.
struct RenderControl {
  ProgressCallback progress = {};
  const std::atomic<bool>* stop = nullptr; ///< set from anywhere, it ends the rendering soon
  /// The rendering is stopped when it has taken camera samples for so many seconds; 0: never.
  double pause_after = 0.0;
  /// Where there is one it is called then, with the state after whole samples, and the rendering
  /// goes on behind it.
  std::function<void()> pause = {};
  RayRecord* record = nullptr;  ///< for measurements, gets all rays; needs settings with one thread
  const Peers* peers = nullptr; ///< who renders with this process; null: it is alone
};

/// Renders samples into the state, and returns false when it was stopped before they were done. A
/// tile that reaches its noise gets no more, and nothing gets more once the time is up, see
/// `RenderSettings`.
///
/// The range begins where the state ends (samples that the state has are not rendered again), or
/// anywhere in a state that has not begun, unless what comes before decides on what comes after, as
/// with adaptive sampling, a noise target or a time limit. A range of a rendering with light passes
/// that begins anywhere must be a part's (`RenderPart`), so that its light paths are a part too.
/// Rendering one range after the other gives the bytes of rendering them at once. With adaptive
/// sampling or a noise target a range goes on to the end of the pass in which it ends. After a stop
/// the state holds whole samples, and the same range, or a longer one, takes up the rest.
///
/// With peers all of them render the same range of a rendering that is no part and has no time
/// limit, and each takes its share of each pass. One that is stopped stops the others soon. Then
/// the states of all are the same but for their films, which are the whole together (`add_up_row`),
/// and the counts of rays, which the first has for all.
bool render(const Scene& scene, const Plan& plan, const World& world, SampleRange range,
            RenderState& state, const RenderControl& control = {});

/// What a rendering gives to who looks at it.
struct Rendering {
  Film film;
  RayCounts rays = {};
  double seconds = 0.0;
  double light_seconds = 0.0; ///< of these, in light-side passes
  bool complete = true;       ///< false when it was stopped; not when its time was up
  std::size_t open_tiles = 0; ///< that did not reach `RenderSettings::noise`
};
[[nodiscard]] Rendering end_rendering(RenderState&& state, const Plan& plan, bool complete);

/// Renders all samples of the planned window. The film keeps all bands where `bands` says where to.
[[nodiscard]] Rendering render(const Scene& scene, const Plan& plan, const World& world,
                               const std::optional<BandPlace>& bands = {},
                               const RenderControl& control = {});

} // namespace abbe
