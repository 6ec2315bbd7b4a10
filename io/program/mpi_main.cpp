#include "core/render/peers.h"
#include "core/scene/user_error.h"
#include "io/console/exit_codes.h"
#include "io/console/terminal.h"
#include "io/program/command_line.h"
#include "io/text/read_error.h"

#include <fmt/format.h>

#include <mpi.h>
#include <unistd.h>

#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <thread>
#include <type_traits>

// abbe-mpi: `abbe render` by all ranks of an MPI job. This file alone knows MPI: docs/farm.md.

namespace {

using namespace abbe;

/// Waits for the others. A rank that spins while they render would take a processor from them.
void wait_for(MPI_Request request) {
  int done = 0;
  for (int i = 0; i < 1000 && done == 0; ++i)
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  while (done == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
}

/// Calls `use` with runs of the numbers that are not too long for MPI's counts.
template <class Use>
void by_runs(Peers::Numbers numbers, const Use& use) {
  constexpr std::size_t kMost = 1U << 24U;
  for (std::size_t i = 0; i < numbers.size(); i += kMost)
    use(numbers.subspan(i, std::min(kMost, numbers.size() - i)));
}

void add_up(Peers::Numbers numbers) {
  by_runs(numbers, [](Peers::Numbers run) {
    MPI_Request request{};
    MPI_Iallreduce(MPI_IN_PLACE, run.data(), static_cast<int>(run.size()), MPI_INT64_T, MPI_SUM,
                   MPI_COMM_WORLD, &request);
    wait_for(request);
  });
}

void add_up_in_first(Peers::Numbers numbers, bool first) {
  by_runs(numbers, [&](Peers::Numbers run) {
    MPI_Request request{};
    MPI_Ireduce(first ? MPI_IN_PLACE : run.data(), first ? run.data() : nullptr,
                static_cast<int>(run.size()), MPI_INT64_T, MPI_SUM, 0, MPI_COMM_WORLD, &request);
    wait_for(request);
  });
}

std::vector<std::int64_t> collect_in_first(const std::vector<std::int64_t>& list,
                                           const Peers& peers) {
  const int size = static_cast<int>(list.size());
  std::vector<int> sizes(static_cast<std::size_t>(peers.count)), places(sizes.size());
  MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  int all = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    places[i] = all;
    all += sizes[i];
  }
  std::vector<std::int64_t> result(peers.is_first() ? static_cast<std::size_t>(all) : 0);
  MPI_Gatherv(list.data(), size, MPI_INT64_T, result.data(), sizes.data(), places.data(),
              MPI_INT64_T, 0, MPI_COMM_WORLD);
  return result;
}

/// What ranks tell the first of how far they are. MPI is called by the main thread alone, which
/// renders as the others do, so that news waits until it has something to tell itself.
class ProgressNews {
public:
  explicit ProgressNews(const Peers& peers)
      : peers_(peers), known_(static_cast<std::size_t>(peers.count)) {}
  RenderProgress share(const RenderProgress& own);
  /// All ranks call it at the end: no message is left then.
  void end();

private:
  static constexpr int kTag = 1;
  static constexpr double kBetween = 0.5; ///< seconds
  void receive();

  const Peers& peers_;
  std::thread::id main_ = std::this_thread::get_id();
  std::vector<RenderProgress> known_; ///< of each rank, in the first
  RenderProgress sent_;               ///< is on its way while there is a request
  MPI_Request request_ = MPI_REQUEST_NULL;
  double told_ = 0.0; ///< when
  std::int64_t messages_ = 0;
};

void ProgressNews::receive() {
  MPI_Status status;
  MPI_Probe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &status);
  MPI_Recv(&known_[static_cast<std::size_t>(status.MPI_SOURCE)], sizeof(RenderProgress), MPI_BYTE,
           status.MPI_SOURCE, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  ++messages_;
}

RenderProgress ProgressNews::share(const RenderProgress& own) {
  static_assert(std::is_trivially_copyable_v<RenderProgress>);
  const bool calls = std::this_thread::get_id() == main_;
  if (!peers_.is_first()) {
    int done = 0;
    if (calls && own.seconds - told_ > kBetween) MPI_Test(&request_, &done, MPI_STATUS_IGNORE);
    if (done == 0) return own;
    told_ = own.seconds;
    sent_ = own;
    ++messages_;
    MPI_Isend(&sent_, sizeof sent_, MPI_BYTE, 0, kTag, MPI_COMM_WORLD, &request_);
    return own;
  }
  for (int waits = calls ? 1 : 0; waits != 0;) {
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &waits, MPI_STATUS_IGNORE);
    if (waits != 0) receive();
  }
  known_.front() = own;
  return together(known_);
}

void ProgressNews::end() {
  std::int64_t sent = peers_.is_first() ? 0 : messages_;
  peers_.add_up_in_first(Peers::Numbers(&sent, 1));
  if (peers_.is_first())
    while (messages_ < sent)
      receive();
  wait_for(request_);
}

/// What became of a rank: its exit code, and what it has to say about it.
struct Outcome {
  int code = 0;
  std::string message = {};
};

/// Runs the command. `met` tells whether the ranks have met, see `run`.
Outcome outcome_of(int argc, char** argv, const Peers& peers) {
  try {
    Command command = parse_command_line(argc, argv);
    if (const auto* answered = std::get_if<Answered>(&command)) return {answered->exit_code};
    auto* const render = std::get_if<RenderCommand>(&command);
    if (!render) return {kExitUsage, "abbe-mpi: only render has an MPI form. Use abbe"};
    render->quiet = render->quiet || !peers.is_first();
    return {run(*render, peers)};
  } catch (const ReadError& error) {
    return {kExitUsage, error.what()};
  } catch (const UserError& error) {
    return {kExitUsage, fmt::format("abbe-mpi: {}", error.what())};
  } catch (const std::exception& error) {
    return {kExitFailure, fmt::format("abbe-mpi: {}", error.what())};
  }
}

/// Tells why not all ranks could begin, once, and returns the exit code.
int agree_on_failure(const Outcome& outcome, const Peers& peers) {
  std::vector<int> codes(static_cast<std::size_t>(peers.count));
  MPI_Allgather(&outcome.code, 1, MPI_INT, codes.data(), 1, MPI_INT, MPI_COMM_WORLD);
  const auto failed = std::ranges::find_if(codes, [](int code) { return code != kPeerFailed; });
  const bool speaks = failed - codes.begin() == peers.number;
  if (speaks && !outcome.message.empty())
    say_error(peers.is_first() ? outcome.message
                               : fmt::format("rank {}: {}", peers.number, outcome.message));
  return *failed;
}

/// Sends what is written to a stream nowhere, and returns where it went.
int mute(int stream) {
  const int kept = ::fcntl(stream, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, stream);
  ::close(nowhere);
  return kept;
}

} // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &threads); // the main thread alone calls MPI
  Peers peers;
  MPI_Comm_rank(MPI_COMM_WORLD, &peers.number);
  MPI_Comm_size(MPI_COMM_WORLD, &peers.count);
  bool met = false;
  peers.add_up = [&met](Peers::Numbers numbers) {
    add_up(numbers);
    met = true;
  };
  peers.add_up_in_first = [&](Peers::Numbers numbers) {
    add_up_in_first(numbers, peers.is_first());
  };
  peers.collect_in_first = [&](const std::vector<std::int64_t>& list) {
    return collect_in_first(list, peers);
  };

  ProgressNews news(peers);
  if (!peers.alone())
    peers.share_progress = [&](const RenderProgress& own) { return news.share(own); };

  const bool speaks = peers.is_first();
  if (!speaks) mute(STDOUT_FILENO);
  const int errors = speaks ? STDERR_FILENO : mute(STDERR_FILENO); // all would warn of the same
  Outcome outcome = outcome_of(argc, argv, peers);
  if (!speaks) ::dup2(errors, STDERR_FILENO);
  if (peers.alone()) {
    if (!outcome.message.empty()) say_error(outcome.message);
  } else if (!met) {
    (void)peers.all(false);
    outcome.code = agree_on_failure(outcome, peers);
  } else if (outcome.code == kPeerFailed) {
    outcome.code = agree_on_failure(outcome, peers);
  } else if (!outcome.message.empty()) { // the others are in the middle of the picture
    say_error(fmt::format("rank {}: {}", peers.number, outcome.message));
    MPI_Abort(MPI_COMM_WORLD, outcome.code);
  }
  if (met) news.end();
  const bool said = all_was_said();
  MPI_Finalize();
  return said || outcome.code != 0 ? outcome.code : kExitFailure;
}
