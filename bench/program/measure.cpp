#include "bench/program/measure.h"

#include "bench/reports/result_tables.h"

namespace abbe::bench {

Report measure(const Options& options, const std::function<void(const Table&)>& show,
               const std::function<void(const std::string&)>& tell) {
  Report report;
  report.machine = this_machine();
  show(table_of(report.machine));
  const RenderOptions& render = options.render;
  for (const std::filesystem::path& scene : options.scenes) {
    switch (options.measurement) {
    case Measurement::rays:
      for (const int bands : render.bands ? std::vector{*render.bands} : std::vector{1, 81}) {
        RenderOptions with_bands = render;
        with_bands.bands = bands;
        show(table_of(report.rays.emplace_back(measure_rays(scene, with_bands))));
      }
      break;
    case Measurement::bands:
      show(table_of(report.bands.emplace_back(measure_bands(scene, render))));
      break;
    case Measurement::error:
      report.errors.push_back(measure_error(scene, options.error, tell));
      show(budgets_table(report.errors.back()));
      show(times_table(report.errors.back()));
      break;
    case Measurement::plan:
      show(table_of(report.plans.emplace_back(measure_plan(scene, render))));
      break;
    case Measurement::scaling:
      report.scalings.push_back(measure_scaling(scene, options.scaling, tell));
      for (const Table& table : tables_of(report.scalings.back()))
        show(table);
      break;
    case Measurement::compare:
    case Measurement::done:
      break;
    }
  }
  if (report.rays.size() > 1) show(overview(report.rays));
  return report;
}

} // namespace abbe::bench
