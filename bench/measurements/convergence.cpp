#include "bench/measurements/convergence.h"

#include <algorithm>
#include <cmath>

namespace abbe::bench {
namespace {

/// The time at which the straight line in the logarithms through a and b has the target's error.
double time_on_line(const TimedError& a, const TimedError& b, double target) {
  const double along = std::log(target / a.error) / std::log(b.error / a.error);
  return a.seconds * std::pow(b.seconds / a.seconds, along);
}

} // namespace

std::optional<double> log_log_slope(const std::vector<TimedError>& curve) {
  const auto n = static_cast<double>(curve.size());
  double mean_x = 0.0, mean_y = 0.0;
  for (const TimedError& p : curve) {
    if (!(p.seconds > 0.0) || !(p.error > 0.0)) return std::nullopt;
    mean_x += std::log(p.seconds) / n;
    mean_y += std::log(p.error) / n;
  }
  double xx = 0.0, xy = 0.0;
  for (const TimedError& p : curve) {
    const double dx = std::log(p.seconds) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(p.error) - mean_y);
  }
  if (!(xx > 0.0)) return std::nullopt;
  return xy / xx;
}

std::optional<double> time_to_error(const std::vector<TimedError>& curve, double target) {
  if (curve.empty()) return std::nullopt;
  const auto misses = [target](const TimedError& p) { return p.error > target; };
  const auto met = std::find_if(curve.rbegin(), curve.rend(), misses).base();
  if (met == curve.end()) return std::nullopt;
  if (met == curve.begin()) return met->seconds;
  return time_on_line(*std::prev(met), *met, target);
}

} // namespace abbe::bench
