#include "core/planning/plan_sources.h"

#include "spectral/observer.h"

#include <algorithm>
#include <utility>

namespace abbe {

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
    const auto known = std::find(spectra_.begin(), spectra_.end(), spectrum);
    source.accumulator = static_cast<int>(known - spectra_.begin());
    if (known == spectra_.end()) add_accumulator(spectrum);
    source.factor = BandTable(1.0f, plan_.grid.count());
  }
  plan_.sources.push_back(std::move(source));
  return static_cast<int>(plan_.sources.size()) - 1;
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
