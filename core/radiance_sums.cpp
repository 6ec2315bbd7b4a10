#include "core/radiance_sums.h"

#include <algorithm>
#include <array>

namespace abbe {
namespace {

/// sum of a[i] * b[i], in lanes, so that the compiler may use registers; the order is fixed.
double dot(const float* a, const float* b, std::size_t count) {
  std::array<float, kBandPadding> lanes{};
  for (std::size_t i = 0; i < count; i += kBandPadding)
    for (std::size_t lane = 0; lane < kBandPadding; ++lane)
      lanes[lane] += a[i + lane] * b[i + lane];
  double sum = 0.0;
  for (const float lane : lanes)
    sum += static_cast<double>(lane);
  return sum;
}

} // namespace

RadianceSums::RadianceSums(const Plan& plan)
    : plan_(plan), sums_(plan.accumulators.size() * plan.stride), scratch_(plan.stride) {}

void RadianceSums::clear() {
  std::fill(sums_.begin(), sums_.end(), 0.0f);
}

void RadianceSums::add(int source, const float* throughput, const BandTable& reflectance,
                       float factor, int first, int last) {
  const SourcePlan& s = plan_.sources[static_cast<std::size_t>(source)];
  if (s.factor.zero()) return;
  float* sum = sums(s.accumulator);
  const auto light = s.factor.constant(), part = reflectance.constant();
  if (light && part) {
    const float product = *light * *part * factor;
    for (int b = first; b < last; ++b)
      sum[b] += throughput[b] * product;
  } else {
    for (int b = first; b < last; ++b)
      sum[b] += throughput[b] * (s.factor[b] * reflectance[b] * factor);
  }
}

Xyz RadianceSums::color() const {
  Xyz color{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < plan_.accumulators.size(); ++i) {
    const AccumulatorPlan& weights = plan_.accumulators[i];
    const float* sum = sums_.data() + i * plan_.stride;
    color.x += dot(sum, weights.x.data(), plan_.stride);
    color.y += dot(sum, weights.y.data(), plan_.stride);
    color.z += dot(sum, weights.z.data(), plan_.stride);
  }
  return color;
}

std::span<const float> RadianceSums::radiance() {
  std::fill(scratch_.begin(), scratch_.end(), 0.0f);
  for (std::size_t i = 0; i < plan_.accumulators.size(); ++i)
    accumulate(scratch_.data(), sums_.data() + i * plan_.stride, plan_.accumulators[i].radiance,
               1.0f, 0, plan_.grid.count());
  return {scratch_.data(), static_cast<std::size_t>(plan_.grid.count())};
}

} // namespace abbe
