#include "core/adaptive/sample_allocation.h"

#include "core/adaptive/pixel_quarter.h"
#include "core/adaptive/sample_shares.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>

namespace abbe {

std::uint32_t nearest_power_of_two(double wanted) {
  if (!(wanted > 1.0)) return 1;
  // The exponent of wanted sqrt(2) (IEEE 754).
  const auto bits = std::bit_cast<std::uint64_t>(wanted * std::numbers::sqrt2);
  return 1u << ((bits >> 52) - 1023);
}

std::vector<std::uint32_t> allocate_samples(const Film& film, std::span<const float> shares,
                                            double mean) {
  const PixelWindow& w = film.window();
  assert(shares.size() == w.pixel_count());
  const double most = kLargestShare * mean;
  std::vector<std::uint32_t> result(w.pixel_count());
  const auto samples = [&](double per_share, int x, int y) {
    const float share = shares[w.index(x, y)];
    const auto wanted = share > 0.0f ? nearest_power_of_two(std::min(per_share * share, most))
                                     : static_cast<std::uint32_t>(mean);
    return std::max(film.samples(x, y), wanted);
  };
  const auto total = [&](std::size_t quarter, double per_share) {
    return tbb::parallel_reduce(
        tbb::blocked_range<int>(w.y0, w.y1), std::uint64_t{0},
        [&](const auto& rows, std::uint64_t sum) {
          for (int y = rows.begin(); y < rows.end(); ++y)
            for_each_in_row(w, quarter, y, [&](int x) { sum += samples(per_share, x, y); });
          return sum;
        },
        std::plus<>());
  };
  for (std::size_t quarter = 0; quarter < kQuarters; ++quarter) {
    std::uint64_t pixels = 0;
    for (int y = w.y0; y < w.y1; ++y)
      for_each_in_row(w, quarter, y, [&](int) { ++pixels; });
    const auto budget = static_cast<std::uint64_t>(mean * static_cast<double>(pixels));
    // Bisection in the logarithm. Shares have at most the mean 1.35 times 1.1, and none is less
    // than kSmallestShare 0.9 = 0.3: with 10 times the mean each gets 3 means.
    double low = 0.05 * mean, high = 10.0 * mean;
    for (int i = 0; i < 12; ++i) { // to 200^(2^-12) - 1 = 0.13 %
      const double middle = std::sqrt(low * high);
      (total(quarter, middle) > budget ? high : low) = middle;
    }
    tbb::parallel_for(w.y0, w.y1, [&](int y) {
      for_each_in_row(w, quarter, y, [&](int x) { result[w.index(x, y)] = samples(low, x, y); });
    });
  }
  return result;
}

} // namespace abbe
