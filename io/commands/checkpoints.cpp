#include "io/commands/checkpoints.h"

#include "core/render/memory_need.h"
#include "core/render/peer_sums.h"
#include "io/console/progress.h"
#include "io/console/terminal.h"
#include "io/files/available_memory.h"
#include "io/states/write_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace abbe {
namespace {

/// Writes the state by `write`. False where that failed, which is told.
template <class Write>
bool keep(const Write& write) {
  try {
    write();
    return true;
  } catch (const std::runtime_error& error) {
    say_warning(fmt::format("{}; what was kept before is still there", error.what()));
    return false;
  }
}

/// Keeps the state of all peers. False where that failed, which is told.
bool keep_of_all(const std::filesystem::path& file, const RenderJob& job,
                 const RenderState& state) {
  int next = state.film.window().y0;
  const auto rows = [&](int y, FilmRow& row) {
    add_up_row(state.film, y, job.peers, row);
    next = y + 1;
  };
  const bool kept =
      !job.peers.is_first() || keep([&] { write_state(file, job.info, state, rows); });
  // The others give the first all rows, and the first takes them, also where it could not write.
  FilmRow row;
  while (!job.peers.alone() && next < state.film.window().y1)
    rows(next, row);
  return kept;
}

/// Writes states while the rendering goes on, one at a time.
class WriterBehind {
public:
  WriterBehind(const std::filesystem::path& file, const RenderJob& job) : file_(file), job_(job) {}

  /// Copies the state and begins to write it, unless the one before is not written yet. Writes it
  /// at once where a copy would take more than half of the memory that is left.
  void keep_soon(const RenderState& state, const BandPlace& place) {
    if (busy_) return;
    if (!job_.peers.alone() ||
        memory_need(job_.scene, job_.plan, bands_of(state, place)) > available_memory() / 2) {
      keep_of_all(file_, job_, state);
      return;
    }
    wait();
    busy_ = true;
    try {
      thread_ = std::jthread([this, copy = copy_of(state, place)] {
        keep([&] { write_state(file_, job_.info, copy); });
        busy_ = false;
      });
    } catch (const std::exception&) { // there is no room for a copy
      busy_ = false;
      keep_of_all(file_, job_, state);
    }
  }
  /// Waits for the one that is being written.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }

private:
  static std::optional<BandPlace> bands_of(const RenderState& state, const BandPlace& place) {
    BandPlace as_it_is = place;
    as_it_is.spectra = state.film.bands() > 0;
    return as_it_is;
  }
  const std::filesystem::path& file_;
  const RenderJob& job_;
  std::atomic<bool> busy_ = false;
  std::jthread thread_;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
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
  const RenderProgress before{.fraction = std::max(state.done - range.first, 0) / length,
                              .seconds = state.seconds,
                              .rays = state.rays};
  const auto tell = [&](const RenderProgress& now) { progress.tell(in_all(now, before)); };
  RenderControl control{.progress = tell, .stop = &stop, .peers = &job.peers};
  std::optional<WriterBehind> writer;
  if (checkpoints.file) writer.emplace(*checkpoints.file, job);
  double watch_every = 0.5;
  Clock::time_point kept = Clock::now(), watched = kept;
  const auto set_next_pause = [&] {
    const double next_watch = job.watch ? watch_every : kInfinity;
    control.pause_after = writer ? std::min(checkpoints.every_seconds, next_watch) : next_watch;
  };
  const auto pause = [&] {
    if (job.watch && seconds_since(watched) >= watch_every) {
      const Clock::time_point begun = Clock::now();
      job.watch(state);
      watched = Clock::now();
      watch_every = std::max(watch_every, 50.0 * seconds_since(begun));
    }
    if (writer && seconds_since(kept) >= checkpoints.every_seconds) {
      writer->keep_soon(state, checkpoints.place);
      kept = Clock::now();
    }
    set_next_pause();
  };
  if (writer || job.watch) {
    control.pause = pause;
    set_next_pause();
  }
  CheckpointedRender result;
  result.complete = render(job.scene, job.plan, job.world, range, state, control);
  progress.finish();
  if (!writer) return result;
  writer->wait();
  result.kept = keep_of_all(*checkpoints.file, job, state);
  return result;
}

} // namespace abbe
