#include "core/radiance_sums.h"

#include <algorithm>
#include <array>

namespace abbe {
namespace {

/// The sum of sums[i] * weights[i], in lanes, so that the compiler may use registers; the order is
/// fixed.
double dot(const double* sums, const float* weights, std::size_t count) {
  std::array<double, kBandPadding> lanes{};
  for (std::size_t i = 0; i < count; i += kBandPadding)
    for (std::size_t lane = 0; lane < kBandPadding; ++lane)
      lanes[lane] += sums[i + lane] * static_cast<double>(weights[i + lane]);
  double sum = 0.0;
  for (const double lane : lanes)
    sum += lane;
  return sum;
}

} // namespace

RadianceSums::RadianceSums(const Plan& plan)
    : plan_(plan), sums_(plan.accumulators.size() * plan.stride), radiance_(plan.stride) {}

void RadianceSums::clear() {
  std::fill(sums_.begin(), sums_.end(), 0.0);
}

void RadianceSums::add(int source, const float* throughput, const BandTable& reflectance,
                       float factor, int first, int last) {
  const SourcePlan& s = plan_.sources[static_cast<std::size_t>(source)];
  if (s.factor.zero()) return;
  double* sum = sums(s.accumulator);
  const auto light = s.factor.constant(), part = reflectance.constant();
  if (light && part) {
    const float product = *light * *part * factor;
    for (int b = first; b < last; ++b)
      sum[b] += static_cast<double>(throughput[b] * product);
  } else {
    for (int b = first; b < last; ++b)
      sum[b] += static_cast<double>(throughput[b] * (s.factor[b] * reflectance[b] * factor));
  }
}

Xyz RadianceSums::color() const {
  Xyz color{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < plan_.accumulators.size(); ++i) {
    const AccumulatorPlan& weights = plan_.accumulators[i];
    const double* sum = sums_.data() + i * plan_.stride;
    color.x += dot(sum, weights.x.data(), plan_.stride);
    color.y += dot(sum, weights.y.data(), plan_.stride);
    color.z += dot(sum, weights.z.data(), plan_.stride);
  }
  return color;
}

std::span<const float> RadianceSums::radiance() {
  const auto bands = static_cast<std::size_t>(plan_.grid.count());
  for (std::size_t b = 0; b < bands; ++b) {
    double mean = 0.0;
    for (std::size_t i = 0; i < plan_.accumulators.size(); ++i)
      mean += sums_[i * plan_.stride + b] *
              static_cast<double>(plan_.accumulators[i].radiance[static_cast<int>(b)]);
    radiance_[b] = static_cast<float>(mean);
  }
  return {radiance_.data(), bands};
}

} // namespace abbe
