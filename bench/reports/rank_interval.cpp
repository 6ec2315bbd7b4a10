#include "bench/reports/rank_interval.h"

#include <algorithm>
#include <cmath>

namespace abbe::bench {

double rank_sum_probability(int n, int m, int u) {
  // Orders of n numbers and i others in which U is v: the largest of all is one of the n, above all
  // i of the others, or one of the others.
  const auto values = static_cast<std::size_t>(n * m) + 1;
  std::vector<std::vector<double>> of(static_cast<std::size_t>(m) + 1,
                                      std::vector<double>(values, 0.0));
  for (auto& counts : of)
    counts[0] = 1.0; // without any of the n
  for (int k = 1; k <= n; ++k)
    for (std::size_t i = 1; i < of.size(); ++i)
      for (std::size_t v = values; v-- > 0;)
        of[i][v] = (v >= i ? of[i][v - i] : 0.0) + of[i - 1][v];
  double below = 0.0, all = 0.0;
  for (std::size_t v = 0; v < values; ++v) {
    all += of.back()[v];
    if (static_cast<int>(v) <= u) below += of.back()[v];
  }
  return below / all;
}

std::optional<RatioInterval> ratio_interval(const std::vector<double>& first,
                                            const std::vector<double>& second, double confidence) {
  const int n = static_cast<int>(first.size()), m = static_cast<int>(second.size());
  if (n == 0 || m == 0) return std::nullopt;
  std::vector<double> ratios;
  for (const double b : second)
    for (const double a : first)
      ratios.push_back(b / a);
  std::sort(ratios.begin(), ratios.end());
  // The interval without the k lowest and k highest misses when U, or n m - U, is below k + 1.
  int k = -1;
  while (2.0 * rank_sum_probability(n, m, k + 1) <= 1.0 - confidence)
    ++k;
  if (k < 0) return std::nullopt;
  const auto left_out = static_cast<std::size_t>(k);
  return RatioInterval{ratios[left_out], ratios[ratios.size() - 1 - left_out],
                       1.0 - 2.0 * rank_sum_probability(n, m, k)};
}

} // namespace abbe::bench
