// The program of each part of the stress suite:
//   stress_PART short           the rounds that every change must pass
//   stress_PART long COUNTS     all rounds; COUNTS keeps what is done, and a later run goes on
//   there stress_PART round NUMBER    one round, to see a failure again
// It prints its counts, and fails when anything failed.
#include "tests/stress/part.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace abbe::stress {
namespace {

constexpr std::uint64_t kBatch = 32; ///< rounds from one writing of the file to the next

/// A round that throws has failed.
void run_round(std::uint64_t number, Tally& tally) {
  try {
    kPart.round(number, tally);
  } catch (const std::exception& e) {
    tally.fail("exception", fmt::format("round {}: {}", number, e.what()));
  }
}

/// Runs the rounds from `first` up to `end`. The sum does not depend on which thread takes which.
Tally run_rounds(std::uint64_t first, std::uint64_t end) {
  const auto start = std::chrono::steady_clock::now();
  Tally sum;
  std::mutex lock;
  std::atomic<std::uint64_t> next = first;
  const auto work = [&] {
    for (std::uint64_t number = next++; number < end; number = next++) {
      Tally tally;
      run_round(number, tally);
      const std::scoped_lock held(lock);
      sum.add(tally);
    }
  };
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> threads;
  if (kPart.rounds == Rounds::on_all_cores)
    for (unsigned i = 1; i < cores; ++i)
      threads.emplace_back(work);
  work();
  threads.clear();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  sum.rounds_done(end - first, taken.count());
  return sum;
}

Tally run_long(const std::string& file) {
  Tally tally = Tally::read(file);
  while (tally.rounds() < kPart.long_rounds) {
    const std::uint64_t first = tally.rounds();
    tally.add(run_rounds(first, std::min(first + kBatch, kPart.long_rounds)));
    tally.write(file);
  }
  return tally;
}

int run(const std::vector<std::string>& words) {
  Tally tally;
  if (words.size() == 1 && words[0] == "short") {
    tally = run_rounds(0, kPart.short_rounds);
  } else if (words.size() == 2 && words[0] == "long") {
    tally = run_long(words[1]);
  } else if (words.size() == 2 && words[0] == "round") {
    const std::uint64_t number = std::stoull(words[1]);
    tally = run_rounds(number, number + 1);
  } else {
    fmt::print(stderr, "usage: stress_{} short | long COUNTS | round NUMBER\n", kPart.name);
    return 2;
  }
  fmt::print("== {}\n{}", kPart.name, tally.text());
  return tally.passes() ? 0 : 1;
}

} // namespace
} // namespace abbe::stress

int main(int argc, char** argv) {
  try {
    return abbe::stress::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& e) {
    fmt::print(stderr, "stress_{}: {}\n", abbe::stress::kPart.name, e.what());
    return 2;
  }
}
