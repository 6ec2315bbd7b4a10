#include "core/planning/plan_sources.h"

#include "spectral/observer.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>

namespace abbe {
namespace {

/// The same for equal spectra, and for others hardly ever.
std::size_t checksum(const Curve& spectrum) {
  std::size_t sum = 0;
  const auto add = [&sum](double value) {
    constexpr std::size_t kMultiplier = 0x9E3779B97F4A7C15U; // 2^64 over the golden ratio
    sum = std::rotl((sum ^ std::hash<double>()(value)) * kMultiplier, 31);
  };
  for (const SpectralLine& line : spectrum.spectral_lines()) {
    add(line.nm);
    add(line.power);
  }
  if (!spectrum.spectral_lines().empty()) return sum;
  constexpr int kSteps = 810; // of half a nanometre; a library's samples lie on them
  for (int i = 0; i <= kSteps; ++i)
    add(spectrum.at(kLowerNm + (kUpperNm - kLowerNm) * i / kSteps));
  return sum;
}

} // namespace

SourcePlanner::SourcePlanner(Plan& plan) : plan_(plan) {
  per_band_ = plan.grid.count() == 81 || plan.grid.count() == 405;
  if (per_band_) add_accumulator(Curve::constant(1.0));
}

int SourcePlanner::add(const Curve& spectrum) {
  SourcePlan source;
  if (per_band_ && spectrum.spectral_lines().empty()) {
    const auto constant = spectrum.constant_value();
    source.factor = constant && plan_.settings.skip.constant_curves
                        ? BandTable(static_cast<float>(*constant), plan_.grid.count())
                        : BandTable(band_means(plan_.grid, spectrum));
  } else {
    source.accumulator = static_cast<int>(find_or_add(spectrum));
    source.factor = BandTable(1.0f, plan_.grid.count());
  }
  plan_.sources.push_back(std::move(source));
  return static_cast<int>(plan_.sources.size()) - 1;
}

std::size_t SourcePlanner::find_or_add(const Curve& spectrum) {
  const std::size_t sum = checksum(spectrum);
  const auto [first, last] = known_.equal_range(sum);
  const auto equal = std::find_if(
      first, last, [&](const auto& entry) { return spectra_[entry.second] == spectrum; });
  if (equal != last) return equal->second;
  add_accumulator(spectrum);
  known_.emplace(sum, spectra_.size() - 1);
  return spectra_.size() - 1;
}

void SourcePlanner::add_accumulator(const Curve& spectrum) {
  spectra_.push_back(spectrum);
  AccumulatorPlan accumulator;
  for (auto* axis : {&accumulator.x, &accumulator.y, &accumulator.z})
    axis->resize(plan_.stride);
  const auto weights = band_weights(plan_.grid, spectrum, plan_.settings.observer);
  for (std::size_t b = 0; b < weights.size(); ++b) {
    accumulator.x[b] = static_cast<float>(weights[b].x);
    accumulator.y[b] = static_cast<float>(weights[b].y);
    accumulator.z[b] = static_cast<float>(weights[b].z);
  }
  accumulator.radiance = BandTable(band_means(plan_.grid, spectrum));
  plan_.accumulators.push_back(std::move(accumulator));
}

} // namespace abbe
