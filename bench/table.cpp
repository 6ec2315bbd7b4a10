#include "bench/table.h"

#include <fmt/format.h>

#include <iterator>

namespace abbe::bench {
namespace {

std::string size_of(const RenderSettings& s) {
  std::string text = fmt::format("{}x{}", s.width, s.height);
  if (s.crop)
    text += fmt::format(" crop {},{},{},{}", s.crop->x0, s.crop->y0, s.crop->x1, s.crop->y1);
  return text;
}

/// Half the range over the median, in percent.
double percent_spread(const Spread& s) {
  return s.median > 0.0 ? 50.0 * (s.highest - s.lowest) / s.median : 0.0;
}

double mega_per_second(std::size_t rays, double seconds) {
  return seconds > 0.0 ? static_cast<double>(rays) / seconds * 1e-6 : 0.0;
}

std::string seconds_or_dash(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.3g}", *seconds) : "-";
}

} // namespace

std::string table(const Machine& m) {
  return fmt::format("{}, {} threads, load {:.1f}; abbe {}, {}, Embree {}, {} for {}\n"
                     "Seconds are processor time summed over the threads, medians; +- is half the "
                     "range of the repeats.\n",
                     m.processor, m.threads, m.load, m.abbe, m.compiler, m.embree, m.build_type,
                     m.architecture);
}

std::string table(const RaySpeed& r) {
  std::string text = fmt::format(
      "\n{}, {}, {} bands, {} spp: {:.3f} s +-{:.0f} % ({:.3f} s wall), {:.2f} Mray per "
      "processor second\n"
      "  {:10} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9} {:>11} {:>6}\n",
      r.scene, size_of(r.settings), r.settings.bands, r.settings.samples_per_pixel,
      r.render_seconds.median, percent_spread(r.render_seconds), r.render_wall_seconds.median,
      mega_per_second(r.counts.total(), r.render_seconds.median), "Mray/s of", "rays", "renderer",
      "embree 1", "embree 4", "embree 8", "embree 16", "world query", "ratio");
  for (const KindSpeed& k : r.kinds) {
    fmt::format_to(std::back_inserter(text), "  {:10} {:>10} {:>9.3f}", name(k.kind), k.rays,
                   mega_per_second(k.rays, r.render_seconds.median));
    for (const Spread& s : k.replay_seconds)
      fmt::format_to(std::back_inserter(text), " {:>9.3f}", mega_per_second(k.rays, s.median));
    fmt::format_to(std::back_inserter(text), " {:>11.3f} {:>6.2f}\n",
                   mega_per_second(k.rays, k.query_seconds.median),
                   k.best_replay_seconds() / k.query_seconds.median);
  }
  fmt::format_to(std::back_inserter(text),
                 "  all rays: raw Embree {:.2f} Mray/s, renderer {:.2f} Mray/s, ratio {:.2f}\n",
                 mega_per_second(r.counts.total(), r.best_replay_seconds()),
                 mega_per_second(r.counts.total(), r.render_seconds.median), r.ratio());
  return text;
}

std::string table(const BandCosts& c) {
  std::string text =
      fmt::format("\n{}, {}, {} spp\n  {:>5} {:>9} {:>5} {:>9} {:>8} {:>10} {:>9}\n", c.scene,
                  size_of(c.settings), c.settings.samples_per_pixel, "bands", "seconds", "+- %",
                  "wall s", "x 1 band", "rays", "Mray/s");
  for (const BandCost& cost : c.costs)
    fmt::format_to(
        std::back_inserter(text), "  {:>5} {:>9.3f} {:>5.0f} {:>9.3f} {:>8.2f} {:>10} {:>9.2f}\n",
        cost.bands, cost.render_seconds.median, percent_spread(cost.render_seconds),
        cost.wall_seconds.median,
        cost.render_seconds.median / c.costs.front().render_seconds.median, cost.counts.total(),
        mega_per_second(cost.counts.total(), cost.render_seconds.median));
  return text;
}

std::string table(const ErrorCurves& e) {
  std::string text =
      fmt::format("\n{}, {}, {} bands; reference: exact, {} spp, {:.1f} s\n"
                  "  {:24} {:>5} {:>9} {:>5} {:>9} {:>10} {:>9} {:>8} {:>8}\n",
                  e.scene, size_of(e.reference), e.reference.bands, e.reference.samples_per_pixel,
                  e.reference_seconds, "variation", "spp", "seconds", "+- %", "rays", "relMSE",
                  "RMSE XYZ", "dE mean", "dE 95 %");
  for (const ErrorCurve& curve : e.curves)
    for (const BudgetError& b : curve.budgets)
      fmt::format_to(
          std::back_inserter(text),
          "  {:24} {:>5} {:>9.3f} {:>5.0f} {:>9} {:>10.3e} {:>9.2e} {:>8.3f} {:>8.3f}{}\n",
          curve.variation.name, b.samples, b.render_seconds.median,
          percent_spread(b.render_seconds), b.rays, b.error.rel_mse, b.error.rmse_xyz,
          b.error.mean_delta_e, b.error.delta_e_95,
          b.error.band_noise ? fmt::format("  band noise {:.2e}", *b.error.band_noise) : "");
  fmt::format_to(std::back_inserter(text), "  {:24} {:>9} {:>12} {:>12}\n", "variation", "slope",
                 "s to 1e-2", "s to 1e-3");
  for (const ErrorCurve& curve : e.curves) {
    const std::vector<TimedError> points = curve.rel_mse_curve();
    const auto slope = log_log_slope(points);
    fmt::format_to(std::back_inserter(text), "  {:24} {:>9} {:>12} {:>12}\n", curve.variation.name,
                   slope ? fmt::format("{:.2f}", *slope) : "-",
                   seconds_or_dash(time_to_error(points, 1e-2)),
                   seconds_or_dash(time_to_error(points, 1e-3)));
  }
  return text;
}

} // namespace abbe::bench
