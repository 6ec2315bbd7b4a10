#include "core/planning/plan_bands.h"

#include "core/bands/band_math.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace abbe {
namespace {

/// True when some source emits in this band and the observer sees it.
bool is_lit(const Plan& plan, int band) {
  return std::any_of(plan.sources.begin(), plan.sources.end(), [&](const SourcePlan& s) {
    const AccumulatorPlan& a = plan.accumulators[static_cast<std::size_t>(s.accumulator)];
    const auto i = static_cast<std::size_t>(band);
    const bool seen = a.x[i] != 0.0f || a.y[i] != 0.0f || a.z[i] != 0.0f;
    return seen && s.factor[band] != 0.0f;
  });
}

/// The bands that are lit. Where none is and alpha is asked for, these are the bands that the
/// observer sees: what passes through the scene is known without any light.
void find_live_bands(Plan& plan) {
  const bool dark = nothing_gives_light(plan);
  const bool by_alpha = dark && plan.sky.lets_through;
  const auto alive = [&](int b) {
    return by_alpha ? plan.sky.y[static_cast<std::size_t>(b)] != 0.0f : is_lit(plan, b);
  };
  int first = 0, last = plan.grid.count();
  while (first < last && !alive(first))
    ++first;
  while (last > first && !alive(last - 1))
    --last;
  plan.live.assign(plan.stride, 0.0f);
  for (int b = first; b < last; ++b)
    if (alive(b)) plan.live[static_cast<std::size_t>(b)] = 1.0f;
  plan.live_count = static_cast<int>(std::count(plan.live.begin(), plan.live.end(), 1.0f));
  plan.live_first = first;
  plan.live_last = last;
  const bool skip = plan.settings.skip.dead_bands;
  plan.first_band = skip ? first : 0;
  plan.last_band = skip ? last : plan.grid.count();
  const int dead = plan.grid.count() - (last - first);
  if (dead == 0 && !dark) return;
  if (dark) {
    plan.notes.push_back("nothing gives light: the picture is black");
    return;
  }
  plan.notes.push_back(fmt::format("{} of {} bands carry no light (only {:.1f} to {:.1f} nm do){}",
                                   dead, plan.grid.count(), plan.grid.lower_nm(first),
                                   plan.grid.lower_nm(last),
                                   skip ? ": left out" : ": carried, as asked"));
}

/// Adds what each band counts in the picture of a source: its parts of X, Y and Z, each in
/// proportion to what all bands give, as the length of a vector.
void add_seen(const Plan& plan, const SourcePlan& source, std::vector<double>& seen) {
  const AccumulatorPlan& a = plan.accumulators[static_cast<std::size_t>(source.accumulator)];
  for (const std::vector<float>* weights : {&a.x, &a.y, &a.z}) {
    const auto value = [&](std::size_t b) {
      return static_cast<double>(source.factor[static_cast<int>(b)] * (*weights)[b]);
    };
    double sum = 0.0;
    for (std::size_t b = 0; b < seen.size(); ++b)
      sum += value(b);
    if (!(sum > 0.0)) continue;
    for (std::size_t b = 0; b < seen.size(); ++b)
      seen[b] += std::pow(value(b) / sum, 2);
  }
}

BandShares shares_of(const Plan& plan) {
  std::vector<double> squares(static_cast<std::size_t>(plan.grid.count()));
  for (const SourcePlan& source : plan.sources)
    add_seen(plan, source, squares);
  if (std::ranges::none_of(squares, [](double s) { return s > 0.0; }))
    std::ranges::copy(std::span(plan.sky.y).first(squares.size()), squares.begin());
  for (double& s : squares)
    s = std::sqrt(s);
  return BandShares(squares);
}

/// Summed as RadianceSums does it, so that a path on which nothing is lost lets exactly 1 through.
void find_clear_sky(Plan& plan) {
  SkyPlan& sky = plan.sky;
  const auto sum = [&](const std::vector<float>& weights) {
    return static_cast<double>(
        weighted_sum(plan.live.data(), weights.data(), plan.first_band, plan.last_band));
  };
  sky.clear = {sum(sky.x), sum(sky.y), sum(sky.z)};
}

} // namespace

bool nothing_gives_light(const Plan& plan) {
  for (int b = 0; b < plan.grid.count(); ++b)
    if (is_lit(plan, b)) return false;
  return true;
}

void plan_bands(Plan& plan) {
  find_live_bands(plan);
  find_clear_sky(plan);
  plan.shares = shares_of(plan);
}

} // namespace abbe
