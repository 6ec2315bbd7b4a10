#include "core/film/radiance_parts.h"

#include <algorithm>

namespace abbe {

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
  double x = 0.0, y = 0.0, z = 0.0;
  for (int b = throughput.bands.first; b < throughput.bands.last; ++b) {
    const auto i = static_cast<std::size_t>(b);
    const auto light =
        static_cast<double>(throughput[b] * (source.factor[b] * reflectance[b] * factor));
    x += light * static_cast<double>(weights.x[i]);
    y += light * static_cast<double>(weights.y[i]);
    z += light * static_cast<double>(weights.z[i]);
  }
  const Xyz color{x, y, z};
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
