#pragma once

#include <optional>
#include <vector>

namespace abbe::bench {

/// One budget of a time-error curve.
struct TimedError {
  double seconds = 0.0, error = 0.0;
};

/// The exponent k of error = c seconds^k, fitted by least squares in the logarithms: -1 for the
/// mean squared error of independent samples. Nothing with fewer than two different times, or
/// where something is not positive.
[[nodiscard]] std::optional<double> log_log_slope(const std::vector<TimedError>& curve);

/// When the error falls to `target` for good, on straight lines between the budgets in the
/// logarithms. The curve is ordered by time. Met by the first budget already: its time, as an upper
/// limit. Nothing where the last budget misses: a curve that ends in a bias would not go on as it
/// began.
[[nodiscard]] std::optional<double> time_to_error(const std::vector<TimedError>& curve,
                                                  double target);

} // namespace abbe::bench
