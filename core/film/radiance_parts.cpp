#include "core/film/radiance_parts.h"

#include <algorithm>
#include <cstring>

namespace abbe {
namespace {

constexpr int kPartLanes = 4;
using PartLights = float __attribute__((vector_size(kPartLanes * sizeof(float))));
using PartSums = double __attribute__((vector_size(kPartLanes * sizeof(double))));

PartLights lanes_at(const float* values) {
  PartLights lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

double sum_of(const PartSums& lanes) {
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/// The colour of light in the throughput's bands, in lanes whose order is fixed.
Xyz color_of(const BandTable& light, const AccumulatorPlan& weights,
             BandSpan<const float> throughput, const BandTable& reflectance, float factor) {
  const auto [first, last] = throughput.bands;
  PartSums x{}, y{}, z{};
  int b = first;
  for (; b + kPartLanes <= last; b += kPartLanes) {
    const PartLights product =
        lanes_at(throughput.data + b) *
        (lanes_at(light.data() + b) * lanes_at(reflectance.data() + b) * factor);
    const PartSums band = __builtin_convertvector(product, PartSums);
    x += band * __builtin_convertvector(lanes_at(weights.x.data() + b), PartSums);
    y += band * __builtin_convertvector(lanes_at(weights.y.data() + b), PartSums);
    z += band * __builtin_convertvector(lanes_at(weights.z.data() + b), PartSums);
  }
  Xyz color{sum_of(x), sum_of(y), sum_of(z)};
  for (; b < last; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const auto band = static_cast<double>(throughput[b] * (light[b] * reflectance[b] * factor));
    color += Xyz{static_cast<double>(weights.x[i]), static_cast<double>(weights.y[i]),
                 static_cast<double>(weights.z[i])} *
             band;
  }
  return color;
}

} // namespace

RadianceParts::RadianceParts(const Plan& plan)
    : plan_(plan), groups_(plan.light_groups.size()),
      unit_(plan.settings.relightable ? plan.light_groups.size() * plan.stride : 0),
      radiance_(plan.stride) {
  clear();
}

void RadianceParts::clear() {
  constexpr Xyz none{0.0, 0.0, 0.0};
  std::ranges::fill(groups_, none);
  std::ranges::fill(views_, none);
  std::ranges::fill(arrivals_, none);
  std::ranges::fill(unit_, 0.0);
  classify(View::direct, Arrival::direct);
}

void RadianceParts::add(const SourcePlan& source, BandSpan<const float> throughput,
                        const BandTable& reflectance, float factor) {
  if (source.group < 0) return;
  const auto group = static_cast<std::size_t>(source.group);
  if (!unit_.empty()) add_unit(group, throughput, reflectance, factor);
  if (source.factor.zero()) return;
  const AccumulatorPlan& weights = plan_.accumulators[static_cast<std::size_t>(source.accumulator)];
  const Xyz color = color_of(source.factor, weights, throughput, reflectance, factor);
  groups_[group] += color;
  views_[view_] += color;
  arrivals_[arrival_] += color;
}

void RadianceParts::add_unit(std::size_t group, BandSpan<const float> throughput,
                             const BandTable& reflectance, float factor) {
  double* const sum = unit_.data() + group * plan_.stride;
  for (int b = throughput.bands.first; b < throughput.bands.last; ++b)
    sum[b] += static_cast<double>(throughput[b] * (reflectance[b] * factor));
}

std::span<const float> RadianceParts::unit_radiance(std::size_t group) {
  const auto bands = static_cast<std::size_t>(plan_.grid.count());
  std::transform(unit_.begin() + static_cast<std::ptrdiff_t>(group * plan_.stride),
                 unit_.begin() + static_cast<std::ptrdiff_t>(group * plan_.stride + bands),
                 radiance_.begin(), [](double v) { return static_cast<float>(v); });
  return {radiance_.data(), bands};
}

} // namespace abbe
