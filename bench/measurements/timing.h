#pragma once

#include <functional>
#include <vector>

namespace abbe::bench {

/// What one run took. `cpu` sums over all threads of this process, so that other programs on the
/// machine lengthen it little.
struct Seconds {
  double wall = 0.0, cpu = 0.0;
};

/// Repeated measurements of one thing, in short.
struct Summary {
  double median = 0.0, lowest = 0.0, highest = 0.0;
  std::vector<double> repeats; ///< all of them, in the order in which they were measured
};

[[nodiscard]] Summary summary(std::vector<double> values);

[[nodiscard]] Seconds time_of(const std::function<void()>& work);

/// The runs of one piece of work.
struct Runs {
  std::vector<double> wall, cpu;

  [[nodiscard]] Summary wall_summary() const { return summary(wall); }
  [[nodiscard]] Summary cpu_summary() const { return summary(cpu); }
};

/// Runs every piece of work once, `repeats` times over, so that a change in the machine's mood
/// falls on all of them alike. One round before is not counted when `warm_up` is set.
[[nodiscard]] std::vector<Runs> interleaved(const std::vector<std::function<void()>>& works,
                                            int repeats, bool warm_up);

/// The number of threads to measure with: `asked`, or one per processor when that is 0.
[[nodiscard]] int thread_count(int asked);

} // namespace abbe::bench
