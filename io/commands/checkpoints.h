#pragma once

#include "core/render/peers.h"
#include "core/render/render.h"
#include "io/states/state_info.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>

namespace abbe {

/// Where and how often the state of a rendering is kept.
struct Checkpoints {
  std::optional<std::filesystem::path> file; ///< empty: nowhere
  double every_seconds = 600.0;
  BandPlace place = {}; ///< where copies of bands go
};

/// A scene that is ready to be rendered. Keeps references.
struct RenderJob {
  const Scene& scene;
  const Plan& plan;
  const World& world;
  const StateInfo& info;
  const Peers& peers;
  /// Where there is one it is called with the state now and then, and takes a fiftieth of the time
  /// at most.
  std::function<void(const RenderState& state)> watch = {};
};

/// What became of it.
struct CheckpointedRender {
  bool complete = false; ///< false when it was stopped
  bool kept = true;      ///< false when the last state could not be kept
};

/// Renders the range of samples as `render` does, and keeps the state now and then and at the end,
/// however it ends. Where memory allows, a copy of it is written while the rendering goes on, and
/// else, and with peers, the rendering waits. Where it cannot be written the user is warned, the
/// file keeps the state before, and the rendering goes on. Of peers the first keeps the state of
/// all.
[[nodiscard]] CheckpointedRender render_with_checkpoints(const RenderJob& job, SampleRange range,
                                                         RenderState& state,
                                                         const Checkpoints& checkpoints,
                                                         const std::atomic<bool>& stop, bool quiet);

} // namespace abbe
