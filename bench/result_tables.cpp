#include "bench/result_tables.h"

#include <fmt/format.h>

namespace abbe::bench {
namespace {

std::string size_of(const RenderSettings& s) {
  std::string text = fmt::format("{}x{}", s.width, s.height);
  if (s.crop)
    text += fmt::format(" crop {},{},{},{}", s.crop->x0, s.crop->y0, s.crop->x1, s.crop->y1);
  return text;
}

std::string seconds(double value) {
  return fmt::format("{:.3f}", value);
}

/// Half the range over the median, in percent.
std::string percent_spread(const Spread& s) {
  const double percent = s.median > 0.0 ? 50.0 * (s.highest - s.lowest) / s.median : 0.0;
  return fmt::format("{:.0f}", percent);
}

std::string mega_per_second(std::size_t rays, double in_seconds) {
  return fmt::format("{:.3f}",
                     in_seconds > 0.0 ? static_cast<double>(rays) / in_seconds * 1e-6 : 0.0);
}

std::string or_dash(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

} // namespace

Table table_of(const Machine& m) {
  return {fmt::format("{}, {} threads, load {:.1f}; abbe {}, {}, Embree {}, {} for {}", m.processor,
                      m.threads, m.load, m.abbe, m.compiler, m.embree, m.build_type,
                      m.architecture),
          {},
          {},
          {"Seconds are processor time summed over the threads, medians; +- is half the range of "
           "the repeats, in percent."}};
}

Table table_of(const RaySpeed& r) {
  Table table{fmt::format("{}, {}, {} bands, {} spp: {} s +-{} % ({} s wall)", r.scene,
                          size_of(r.settings), r.settings.bands, r.settings.samples_per_pixel,
                          seconds(r.render_seconds.median), percent_spread(r.render_seconds),
                          seconds(r.render_wall_seconds.median)),
              {"Mray/s of", "rays", "renderer", "embree 1", "embree 4", "embree 8", "embree 16",
               "world query", "ratio"},
              {},
              {}};
  for (const KindSpeed& k : r.kinds) {
    auto& row = table.rows.emplace_back();
    row = {name(k.kind), fmt::format("{}", k.rays),
           mega_per_second(k.rays, r.render_seconds.median)};
    for (const Spread& s : k.replay_seconds)
      row.push_back(mega_per_second(k.rays, s.median));
    row.push_back(mega_per_second(k.rays, k.query_seconds.median));
    row.push_back(fmt::format("{:.2f}", k.best_replay_seconds() / k.query_seconds.median));
  }
  table.notes.push_back(
      fmt::format("all rays: raw Embree {} Mray/s, renderer {} Mray/s, ratio {:.2f}",
                  mega_per_second(r.counts.total(), r.best_replay_seconds()),
                  mega_per_second(r.counts.total(), r.render_seconds.median), r.ratio()));
  return table;
}

Table table_of(const BandCosts& c) {
  Table table{
      fmt::format("{}, {}, {} spp", c.scene, size_of(c.settings), c.settings.samples_per_pixel),
      {"bands", "seconds", "+- %", "wall s", "x 1 band", "rays", "Mray/s"},
      {},
      {}};
  for (const BandCost& cost : c.costs)
    table.rows.push_back(
        {fmt::format("{}", cost.bands), seconds(cost.render_seconds.median),
         percent_spread(cost.render_seconds), seconds(cost.wall_seconds.median),
         fmt::format("{:.2f}", cost.render_seconds.median / c.costs.front().render_seconds.median),
         fmt::format("{}", cost.counts.total()),
         mega_per_second(cost.counts.total(), cost.render_seconds.median)});
  return table;
}

Table budgets_table(const ErrorCurves& e) {
  Table table{fmt::format("{}, {}, {} bands; reference: exact, {} spp, {:.1f} s", e.scene,
                          size_of(e.reference), e.reference.bands, e.reference.samples_per_pixel,
                          e.reference_seconds),
              {"variation", "spp", "seconds", "+- %", "wall s", "rays", "relMSE", "RMSE XYZ",
               "dE mean", "dE 95 %"},
              {},
              {}};
  bool band_noise = false;
  for (const ErrorCurve& curve : e.curves)
    for (const BudgetError& b : curve.budgets) {
      table.rows.push_back(
          {curve.variation.name, fmt::format("{}", b.samples), seconds(b.render_seconds.median),
           percent_spread(b.render_seconds), seconds(b.wall_seconds.median),
           fmt::format("{}", b.rays), fmt::format("{:.3e}", b.error.rel_mse),
           fmt::format("{:.2e}", b.error.rmse_xyz), fmt::format("{:.3f}", b.error.mean_delta_e),
           fmt::format("{:.3f}", b.error.delta_e_95)});
      if (!b.error.band_noise) continue;
      band_noise = true;
      table.rows.back().push_back(fmt::format("{:.2e}", *b.error.band_noise));
    }
  if (band_noise) table.columns.emplace_back("band noise");
  return table;
}

Table times_table(const ErrorCurves& e) {
  Table table{fmt::format("{}: seconds to an error", e.scene),
              {"variation", "slope", "relMSE 1e-2", "relMSE 1e-3", "relMSE 1e-4",
               fmt::format("dE mean {}", kEqualDeltaE)},
              {},
              {}};
  for (const ErrorCurve& curve : e.curves) {
    const std::vector<TimedError> points = curve.rel_mse_curve();
    auto& row = table.rows.emplace_back();
    row = {curve.variation.name, or_dash(log_log_slope(points))};
    for (const double target : {1e-2, 1e-3, 1e-4})
      row.push_back(or_dash(time_to_error(points, target)));
    row.push_back(or_dash(time_to_error(curve.delta_e_curve(), kEqualDeltaE)));
  }
  if (const auto ratio = e.default_over_exact())
    table.notes.push_back(fmt::format("default over exact at equal error (dE mean {}): {:.3g}",
                                      kEqualDeltaE, *ratio));
  return table;
}

} // namespace abbe::bench
