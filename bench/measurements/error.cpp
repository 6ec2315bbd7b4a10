#include "bench/measurements/error.h"
#include "core/planning/make_plan.h"
#include "core/scene/user_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace abbe::bench {
namespace {

RenderSettings reference_settings(RenderSettings settings, const ErrorOptions& options) {
  settings.exact = true;
  settings.jitter = true;
  settings.samples_per_pixel = options.reference_samples;
  settings.adaptive = AdaptiveSampling::off;
  settings.noise = settings.seconds = 0.0;
  settings.seed = options.reference_seed;
  return settings;
}

} // namespace

std::vector<TimedError> ErrorCurve::rel_mse_curve() const {
  std::vector<TimedError> curve;
  for (const BudgetError& budget : budgets)
    curve.push_back({budget.render_seconds.median, budget.error.rel_mse});
  return curve;
}

std::vector<TimedError> ErrorCurve::delta_e_curve() const {
  std::vector<TimedError> curve;
  for (const BudgetError& budget : budgets)
    curve.push_back({budget.render_seconds.median, budget.error.mean_delta_e});
  return curve;
}

std::optional<EqualError> ErrorCurves::default_over_exact() const {
  const auto curve_of = [this](std::string_view name) {
    for (const ErrorCurve& curve : curves)
      if (curve.variation.name == name) return curve.delta_e_curve();
    return std::vector<TimedError>();
  };
  const std::vector<TimedError> usual = curve_of("default"), exact = curve_of("exact");
  if (usual.empty() || exact.empty()) return std::nullopt;
  const double target = std::max({kEqualDeltaE, usual.back().error, exact.back().error});
  return EqualError{target, *time_to_error(usual, target) / *time_to_error(exact, target)};
}

ErrorCurves measure_error(const std::filesystem::path& scene_path, const ErrorOptions& options,
                          const std::function<void(const std::string&)>& tell) {
  const Scene scene = load_scene(scene_path);
  const World world = build_world(scene);
  const RenderSettings settings = settings_for(scene, options.render);
  if (settings.seed == options.reference_seed)
    throw UserError("the reference needs a seed other than the scene's");
  ErrorCurves result{scene.title, reference_settings(settings, options), 0.0, {}};
  for (const std::string& text : options.variations) {
    Variation variation = parse_variation(text, settings);
    std::vector<BudgetError> budgets;
    for (const int samples : options.budgets)
      budgets.push_back({samples, {}, {}, 0, {}});
    result.curves.push_back({std::move(variation), std::move(budgets)});
  }

  tell(fmt::format("reference: exact, {} samples per pixel", options.reference_samples));
  std::optional<Rendering> exact;
  result.reference_seconds = time_of([&] {
                               exact = render_once(scene, make_plan(scene, result.reference), world,
                                                   nullptr, options.band_noise);
                             }).cpu;
  const std::vector<Xyz> reference = pixels(exact->film);

  for (std::size_t i = 0; i < options.budgets.size(); ++i) {
    tell(fmt::format("{} samples per pixel", options.budgets[i]));
    std::vector<std::function<void()>> works;
    std::vector<Plan> plans;
    for (const ErrorCurve& curve : result.curves) {
      RenderSettings budgeted = curve.variation.settings;
      budgeted.samples_per_pixel = options.budgets[i];
      plans.push_back(make_plan(scene, budgeted));
    }
    std::vector<std::optional<Rendering>> renderings(plans.size());
    for (std::size_t k = 0; k < plans.size(); ++k)
      works.emplace_back([&, k] {
        renderings[k] = render_once(scene, plans[k], world, nullptr, options.band_noise);
      });
    const std::vector<Runs> runs = interleaved(works, options.render.repeats, false);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      ImageError error = image_error(pixels(renderings[k]->film), reference);
      if (options.band_noise) error.band_noise = band_noise(renderings[k]->film, exact->film);
      result.curves[k].budgets[i] = {options.budgets[i], runs[k].cpu_summary(),
                                     runs[k].wall_summary(), renderings[k]->rays.total(), error};
    }
  }
  return result;
}

} // namespace abbe::bench
