#include "bench/measurements/arithmetic_loop.h"

#include <atomic>
#include <thread>
#include <vector>

namespace abbe::bench {
namespace {

using Lanes [[gnu::vector_size(32)]] = double;

/// Eight chains that do not wait for each other: a product and a sum take some eight cycles, two of
/// each can begin in one.
double chains(std::uint64_t steps) {
  Lanes a{1.0, 1.1, 1.2, 1.3}, b = a + 0.1, c = a + 0.2, d = a + 0.3, e = a + 0.4, f = a + 0.5,
                               g = a + 0.6, h = a + 0.7;
  const Lanes factor = a * 0.0 + 0.999, addend = a * 0.0 + 0.001; // towards 1, never denormal
  for (std::uint64_t i = 0; i < steps; ++i) {
    a = a * factor + addend;
    b = b * factor + addend;
    c = c * factor + addend;
    d = d * factor + addend;
    e = e * factor + addend;
    f = f * factor + addend;
    g = g * factor + addend;
    h = h * factor + addend;
  }
  const Lanes sum = a + b + c + d + e + f + g + h;
  return sum[0] + sum[1] + sum[2] + sum[3];
}

} // namespace

double arithmetic_loop(std::uint64_t steps, int threads) {
  const auto parts = static_cast<std::uint64_t>(threads);
  std::atomic<double> sum = 0.0;
  std::vector<std::jthread> helpers;
  for (std::uint64_t i = 1; i < parts; ++i)
    helpers.emplace_back([&] { sum += chains(steps / parts); });
  sum += chains(steps - steps / parts * (parts - 1));
  helpers.clear(); // joins
  return sum;
}

} // namespace abbe::bench
