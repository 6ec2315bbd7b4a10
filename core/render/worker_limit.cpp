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

int threads_that_can_be_made(int wanted) {
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::vector<std::thread> threads;
  try {
    while (static_cast<int>(threads.size()) < wanted)
      threads.emplace_back([ended] { ended.wait(); });
  } catch (const std::system_error&) {
    // So many, then.
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
  if (allowed < most)
    // It is never destroyed: TBB would make threads at once that it was not allowed before.
    (void)std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(allowed))
        .release();
  return {wanted, std::min(wanted, allowed)};
}

} // namespace abbe
