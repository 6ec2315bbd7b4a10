#include "io/commands/checkpoints.h"

#include "io/console/progress.h"
#include "io/console/terminal.h"
#include "io/states/write_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace abbe {
namespace {

/// Keeps the state. False where that failed, which is told.
bool keep(const Checkpoints& checkpoints, const StateInfo& info, const RenderState& state) {
  if (!checkpoints.file) return true;
  try {
    write_state(*checkpoints.file, info, state);
    return true;
  } catch (const std::runtime_error& error) {
    say_warning(fmt::format("{}; what was kept before is still there", error.what()));
    return false;
  }
}

/// How far a rendering has come in all that came this far before it was taken up again.
RenderProgress in_all(RenderProgress now, const RenderProgress& before) {
  now.fraction = before.fraction + (1.0 - before.fraction) * now.fraction;
  now.seconds += before.seconds;
  now.rays += before.rays;
  return now;
}

} // namespace

CheckpointedRender render_with_checkpoints(const RenderJob& job, SampleRange range,
                                           RenderState& state, const Checkpoints& checkpoints,
                                           const std::atomic<bool>& stop, bool quiet) {
  Progress progress(quiet);
  const double length = range.last - range.first;
  RenderProgress before{.fraction = std::max(state.done - range.first, 0) / length,
                        .seconds = state.seconds,
                        .rays = state.rays};
  CheckpointedRender result;
  for (;;) {
    RenderProgress last = before;
    const auto tell = [&](const RenderProgress& now) {
      last = in_all(now, before);
      progress.tell(last);
    };
    result.complete = render(job.scene, job.plan, job.world, range, state,
                             {.progress = tell,
                              .stop = &stop,
                              .pause_after = checkpoints.file ? checkpoints.every_seconds : 0.0});
    const bool ended = result.complete || stop;
    if (ended) progress.finish();
    result.kept = keep(checkpoints, job.info, state);
    if (ended) return result;
    before = {.fraction = last.fraction, .seconds = state.seconds, .rays = state.rays};
  }
}

} // namespace abbe
