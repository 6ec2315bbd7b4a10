#pragma once

#include <optional>
#include <vector>

namespace abbe::bench {

/// Between which factors the second of two things is slower than the first.
struct RatioInterval {
  double lowest = 0.0, highest = 0.0;
  double confidence = 0.0; ///< at least what was asked for
};

/// A confidence interval for the factor between two series of positive numbers, from the ranks of
/// their pairwise ratios: that of Mann and Whitney's test [Bauer72], in logarithms. It assumes
/// nothing about how the numbers scatter but that both series do so alike. Nothing where so few
/// numbers cannot give the confidence (three and three for 0.95, say).
[[nodiscard]] std::optional<RatioInterval> ratio_interval(const std::vector<double>& first,
                                                          const std::vector<double>& second,
                                                          double confidence);

/// The probability that Mann and Whitney's U of n and m numbers from one distribution is at most u.
[[nodiscard]] double rank_sum_probability(int n, int m, int u);

} // namespace abbe::bench
