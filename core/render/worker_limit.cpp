#include "core/render/worker_limit.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

namespace abbe {
namespace {

/// Adds a thread that waits for the end; false where the system refuses it.
bool add_waiting(std::vector<std::thread>& threads, const std::shared_future<void>& ended) {
  try {
    threads.emplace_back([ended] { ended.wait(); });
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

} // namespace

int threads_that_can_be_made(int wanted) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::vector<std::thread> threads;
  while (static_cast<int>(threads.size()) < wanted && add_waiting(threads, ended)) {
  }
  end.set_value();
  for (std::thread& thread : threads)
    thread.join();
  return static_cast<int>(threads.size());
}

Workers limit_workers(int wanted) {
  const int usual = tbb::info::default_concurrency(); // as Embree has it, whatever is wanted here
  if (wanted <= 0) wanted = usual;
  const int most = std::max(wanted, usual);
  const int allowed = 1 + threads_that_can_be_made(most - 1);
  if (allowed < most) {
    // TBB would make threads at once that it was not allowed before.
    [[maybe_unused]] const tbb::global_control* never_destroyed =
        std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                              static_cast<std::size_t>(allowed))
            .release();
  }
  return {wanted, std::min(wanted, allowed)};
}

} // namespace abbe
