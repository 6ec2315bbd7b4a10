#include "bench/reports/result_tables.h"

#include "bench/reports/figures.h"

#include <fmt/format.h>

namespace abbe::bench {
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
                          size_text(r.settings), r.settings.bands, r.settings.samples_per_pixel,
                          seconds_text(r.render_seconds.median), range_text(r.render_seconds),
                          seconds_text(r.render_wall_seconds.median)),
              {"Mray/s of", "rays", "renderer", "embree 1", "embree 4", "embree 8", "embree 16",
               "world query", "ratio"},
              {},
              {}};
  for (const KindSpeed& k : r.kinds) {
    auto& row = table.rows.emplace_back();
    row = {name(k.kind), fmt::format("{}", k.rays), speed_text(k.rays, r.render_seconds.median)};
    for (const Summary& s : k.replay_seconds)
      row.push_back(speed_text(k.rays, s.median));
    row.push_back(speed_text(k.rays, k.query_seconds.median));
    row.push_back(fmt::format("{:.2f}", k.best_replay_seconds() / k.query_seconds.median));
  }
  table.notes.push_back(
      fmt::format("all rays: raw Embree {} Mray/s, renderer {} Mray/s, ratio {:.2f}",
                  speed_text(r.counts.total(), r.best_replay_seconds()),
                  speed_text(r.counts.total(), r.render_seconds.median), r.ratio()));
  return table;
}

Table overview(const std::vector<RaySpeed>& speeds) {
  Table table{"all of them: Mray per processor second",
              {"scene", "bands", "seconds", "+- %", "rays", "renderer", "raw Embree", "world query",
               "ratio"},
              {},
              {}};
  for (const RaySpeed& r : speeds)
    table.rows.push_back(
        {r.scene, fmt::format("{}", r.settings.bands), seconds_text(r.render_seconds.median),
         range_text(r.render_seconds), fmt::format("{}", r.counts.total()),
         speed_text(r.counts.total(), r.render_seconds.median),
         speed_text(r.counts.total(), r.best_replay_seconds()),
         speed_text(r.counts.total(), r.query_seconds()), fmt::format("{:.2f}", r.ratio())});
  return table;
}

Table table_of(const BandCosts& c) {
  Table table{
      fmt::format("{}, {}, {} spp", c.scene, size_text(c.settings), c.settings.samples_per_pixel),
      {"bands", "seconds", "+- %", "wall s", "x 1 band", "rays", "Mray/s"},
      {},
      {}};
  for (const BandCost& cost : c.costs)
    table.rows.push_back(
        {fmt::format("{}", cost.bands), seconds_text(cost.render_seconds.median),
         range_text(cost.render_seconds), seconds_text(cost.wall_seconds.median),
         fmt::format("{:.2f}", cost.render_seconds.median / c.costs.front().render_seconds.median),
         fmt::format("{}", cost.counts.total()),
         speed_text(cost.counts.total(), cost.render_seconds.median)});
  return table;
}

Table budgets_table(const ErrorCurves& e) {
  Table table{fmt::format("{}, {}, {} bands; reference: exact, {} spp, {:.1f} s", e.scene,
                          size_text(e.reference), e.reference.bands, e.reference.samples_per_pixel,
                          e.reference_seconds),
              {"variation", "spp", "seconds", "+- %", "wall s", "rays", "relMSE", "RMSE XYZ",
               "dE mean", "dE 95 %"},
              {},
              {}};
  bool band_noise = false;
  for (const ErrorCurve& curve : e.curves)
    for (const BudgetError& b : curve.budgets) {
      table.rows.push_back(
          {curve.variation.name, fmt::format("{}", b.samples),
           seconds_text(b.render_seconds.median), range_text(b.render_seconds),
           seconds_text(b.wall_seconds.median), fmt::format("{}", b.rays),
           fmt::format("{:.3e}", b.error.rel_mse), fmt::format("{:.2e}", b.error.rmse_xyz),
           fmt::format("{:.3f}", b.error.mean_delta_e), fmt::format("{:.3f}", b.error.delta_e_95)});
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
  if (const auto equal = e.default_over_exact())
    table.notes.push_back(
        fmt::format("default over exact at equal error (dE mean {:.3g}): {:.3g} of the time",
                    equal->mean_delta_e, equal->ratio));
  return table;
}

Table table_of(const SkipCosts& c) {
  Table table{fmt::format("{}, {}, {} bands, {} spp: {} of {} tiles empty, {} of {} bands dead",
                          c.scene, size_text(c.settings), c.settings.bands,
                          c.settings.samples_per_pixel, c.empty_tiles, c.tiles, c.dead_bands,
                          c.settings.bands),
              {"not skipped", "seconds", "+- %", "wall s", "ratio", "from", "to", "changed pixels"},
              {},
              {}};
  for (const SkipCost& cost : c.costs)
    table.rows.push_back(
        {cost.without, seconds_text(cost.render_seconds.median), range_text(cost.render_seconds),
         seconds_text(cost.wall_seconds.median), fmt::format("{:.3f}", cost.ratio.median),
         fmt::format("{:.3f}", cost.ratio.lowest), fmt::format("{:.3f}", cost.ratio.highest),
         fmt::format("{}", cost.changed_pixels)});
  return table;
}

} // namespace abbe::bench
