#include "bench/measurements/timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>

namespace abbe::bench {

Summary summary(std::vector<double> values) {
  if (values.empty()) return {};
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return {0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]), sorted.front(), sorted.back(),
          std::move(values)};
}

Seconds time_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  work();
  const std::clock_t cpu_end = std::clock();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), static_cast<double>(cpu_end - cpu_start) / CLOCKS_PER_SEC};
}

std::vector<Runs> interleaved(const std::vector<std::function<void()>>& works, int repeats,
                              bool warm_up) {
  std::vector<Runs> runs(works.size());
  for (int round = warm_up ? -1 : 0; round < repeats; ++round)
    for (std::size_t i = 0; i < works.size(); ++i) {
      const Seconds seconds = time_of(works[i]);
      if (round < 0) continue;
      runs[i].wall.push_back(seconds.wall);
      runs[i].cpu.push_back(seconds.cpu);
    }
  return runs;
}

int thread_count(int asked) {
  if (asked > 0) return asked;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace abbe::bench
