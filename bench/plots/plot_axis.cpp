#include "bench/plots/plot_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace abbe::bench {
namespace {

/// The smallest of 1, 2, 5, 10, 20 ... (or 0.5, 0.2 ...) that is not below `value`, but for
/// rounding.
double round_step(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= value * (1.0 - 1e-9)) return factor * decade; // of a label, not a result
  return 10.0 * decade;
}

/// "0.01", "500", "2e6".
std::string label_of(int digit, double decade) {
  const int power = static_cast<int>(decade);
  return power < -3 || power > 4 ? fmt::format("{}e{}", digit, power)
                                 : fmt::format("{:.6g}", digit * std::pow(10.0, decade));
}

} // namespace

PlotAxis::PlotAxis(const std::vector<double>& values, Scale scale, bool from_zero) : scale_(scale) {
  const bool logarithmic = scale == Scale::logarithmic;
  double least = logarithmic ? 1.0 : 0.0, most = logarithmic ? 10.0 : 1.0;
  bool first = true;
  for (const double v : values) {
    if (!std::isfinite(v) || !shows(v)) continue;
    least = first ? v : std::min(least, v);
    most = first ? v : std::max(most, v);
    first = false;
  }
  if (logarithmic)
    set_logarithmic(least, most);
  else
    set_even(from_zero ? std::min(least, 0.0) : least, from_zero ? std::max(most, 0.0) : most);
}

void PlotAxis::set_even(double least, double most) {
  constexpr double kSteps = 5.0; // at least about so many
  if (!(most > least)) most = least + std::max(std::abs(least), 1.0);
  double step = round_step((most - least) / kSteps);
  if (scale_ == Scale::whole) step = std::max(step, 1.0);
  const double first = std::floor(least / step), last = std::ceil(most / step - 1e-9);
  for (double i = first; i <= last; i += 1.0)
    ticks_.push_back({i * step, fmt::format("{:.6g}", i * step)});
  lower_ = first * step;
  upper_ = last * step;
}

void PlotAxis::set_logarithmic(double least, double most) {
  constexpr double kFew = 100.0; // a range that leaves room for more labels
  double first = std::floor(std::log10(least)), last = std::ceil(std::log10(most));
  if (last == first) last += 1.0;
  for (double decade = first; decade <= last; decade += 1.0) {
    const double unit = std::pow(10.0, decade);
    ticks_.push_back({unit, label_of(1, decade)});
    for (int digit = 2; digit < 10 && decade < last; ++digit) {
      const bool labelled = most <= least * kFew && (digit == 2 || digit == 5);
      ticks_.push_back({digit * unit, labelled ? label_of(digit, decade) : ""});
    }
  }
  // Ends need not be decades: the ticks around the values are near enough.
  const auto low = std::find_if(ticks_.rbegin(), ticks_.rend(),
                                [least](const Tick& t) { return t.value <= least; });
  const auto high =
      std::find_if(ticks_.begin(), ticks_.end(), [most](const Tick& t) { return t.value >= most; });
  lower_ = low != ticks_.rend() ? low->value : ticks_.front().value;
  upper_ = high != ticks_.end() ? high->value : ticks_.back().value;
  if (!(upper_ > lower_)) {
    lower_ = ticks_.front().value;
    upper_ = ticks_.back().value;
  }
  std::erase_if(ticks_, [this](const Tick& t) { return t.value < lower_ || t.value > upper_; });
}

double PlotAxis::place(double value) const {
  if (scale_ != Scale::logarithmic) return (value - lower_) / (upper_ - lower_);
  return std::log(value / lower_) / std::log(upper_ / lower_);
}

} // namespace abbe::bench
