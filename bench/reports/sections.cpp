#include "bench/reports/sections.h"

#include "bench/reports/result_plots.h"
#include "bench/reports/result_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace abbe::bench {
namespace {

std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

/// Names that came before get a number.
void make_names_differ(std::vector<Section>& sections) {
  std::map<std::string, int> seen;
  for (Section& section : sections)
    for (NamedPlot& plot : section.plots)
      if (const int before = seen[plot.name]++; before > 0)
        plot.name += fmt::format("_{}", before + 1);
}

std::vector<NamedPlot> plots_of(const Scaling& s) {
  std::vector<NamedPlot> plots;
  if (!s.threads.empty())
    plots.push_back({file_name("scaling_threads_" + s.scene), to_svg(threads_plot(s))});
  if (!s.sizes.empty())
    plots.push_back({file_name("scaling_size_" + s.scene), to_svg(sizes_plot(s))});
  if (!s.samples.empty())
    plots.push_back({file_name("scaling_samples_" + s.scene), to_svg(samples_plot(s))});
  if (!s.triangles.empty() || !s.lenses.empty()) {
    plots.push_back({"scaling_ray_time", to_svg(ray_time_plot(s))});
    plots.push_back({"scaling_build_time", to_svg(build_time_plot(s))});
  }
  return plots;
}

} // namespace

std::vector<Section> sections_of(const Report& report) {
  std::vector<Section> sections;
  sections.push_back({{table_of(report.machine)}, {}});
  for (const RaySpeed& r : report.rays)
    sections.push_back({{table_of(r)},
                        {{file_name(fmt::format("rays_{}_{}", r.scene, r.settings.bands)),
                          to_svg(rays_plot(r))}}});
  if (report.rays.size() > 1) sections.push_back({{overview(report.rays)}, {}});
  if (!report.bands.empty()) {
    Section section;
    for (const BandCosts& costs : report.bands)
      section.tables.push_back(table_of(costs));
    section.plots.push_back({"bands", to_svg(bands_plot(report.bands))});
    sections.push_back(std::move(section));
  }
  for (const ErrorCurves& e : report.errors)
    sections.push_back({{budgets_table(e), times_table(e)},
                        {{file_name("error_" + e.scene), to_svg(rel_mse_plot(e))},
                         {file_name("colour_difference_" + e.scene), to_svg(delta_e_plot(e))}}});
  if (!report.plans.empty()) {
    Section section;
    for (const SkipCosts& costs : report.plans)
      section.tables.push_back(table_of(costs));
    section.plots.push_back({"plan", to_svg(plan_plot(report.plans))});
    sections.push_back(std::move(section));
  }
  for (const Scaling& s : report.scalings)
    sections.push_back({tables_of(s), plots_of(s)});
  make_names_differ(sections);
  return sections;
}

} // namespace abbe::bench
