#include "bench/reports/result_plots.h"

#include "bench/reports/figures.h"

#include <fmt/format.h>

namespace abbe::bench {
namespace {

PlotValue with_range(const Summary& s, double factor = 1.0) {
  return {factor * s.median, factor * s.lowest, factor * s.highest};
}

/// Mray/s of so many rays.
PlotValue speed(std::size_t rays, const Summary& seconds) {
  const double mega = 1e-6 * static_cast<double>(rays);
  return {mega / seconds.median, mega / seconds.highest, mega / seconds.lowest};
}

LinePlot error_plot(const ErrorCurves& curves, const char* what,
                    std::vector<TimedError> (ErrorCurve::*points)() const) {
  LinePlot plot{fmt::format("{}, {}, {} bands", curves.scene, size_text(curves.reference),
                            curves.reference.bands),
                "processor seconds",
                what,
                Scale::logarithmic,
                Scale::logarithmic,
                {}};
  for (const ErrorCurve& curve : curves.curves) {
    PlotLine line{curve.variation.name, {}};
    for (const TimedError& p : (curve.*points)())
      line.points.push_back({p.seconds, {p.error}});
    plot.lines.push_back(std::move(line));
  }
  return plot;
}

PlotLine line_of(const std::string& name, const std::vector<PrimitivePoint>& points,
                 PlotValue (*value)(const PrimitivePoint&)) {
  PlotLine line{name, {}};
  for (const PrimitivePoint& p : points)
    line.points.push_back({static_cast<double>(p.primitives), value(p)});
  return line;
}

LinePlot primitives_plot(const Scaling& s, const char* title, const char* y_label,
                         PlotValue (*value)(const PrimitivePoint&)) {
  LinePlot plot{title, "primitives", y_label, Scale::logarithmic, Scale::logarithmic, {}};
  if (!s.triangles.empty())
    plot.lines.push_back(line_of("triangles of a ball", s.triangles, value));
  if (!s.lenses.empty()) plot.lines.push_back(line_of("lenses of two balls", s.lenses, value));
  return plot;
}

LinePlot pictures_plot(const Scaling& s, const std::vector<ImagePoint>& points, const char* x_label,
                       double (*x)(const RenderSettings&)) {
  PlotLine line{s.scene, {}};
  for (const ImagePoint& p : points)
    line.points.push_back({x(p.settings), with_range(p.render_seconds)});
  return {fmt::format("{}, {} bands", s.scene, s.settings.bands),
          x_label,
          "processor seconds",
          Scale::logarithmic,
          Scale::logarithmic,
          {line}};
}

} // namespace

BarPlot rays_plot(const RaySpeed& r) {
  BarPlot plot{
      fmt::format("{}, {} bands", r.scene, r.settings.bands), "Mray per processor second", {}, {}};
  PlotBars embree{"raw Embree, packets", {}}, single{"raw Embree, single", {}},
      query{"world query", {}};
  for (const KindSpeed& k : r.kinds) {
    plot.groups.emplace_back(name(k.kind));
    embree.values.push_back(speed(k.rays, k.best_replay()));
    single.values.push_back(speed(k.rays, k.replay_seconds.front()));
    query.values.push_back(speed(k.rays, k.query_seconds));
  }
  plot.groups.emplace_back("rendering");
  const double all = 1e-6 * static_cast<double>(r.counts.total());
  embree.values.push_back({all / r.best_replay_seconds()});
  single.values.push_back({all / r.single_replay_seconds()});
  query.values.push_back({all / r.query_seconds()});
  PlotBars renderer{"renderer", std::vector<PlotValue>(r.kinds.size(), {kNone})};
  renderer.values.push_back(speed(r.counts.total(), r.render_seconds));
  plot.bars = {embree, single, query, renderer};
  return plot;
}

BarPlot bands_plot(const std::vector<BandCosts>& all) {
  BarPlot plot{"time over that at 1 band", "times", {}, {}};
  for (const BandCosts& costs : all) {
    plot.groups.push_back(costs.scene);
    const double one = costs.costs.front().render_seconds.median;
    for (std::size_t i = 0; i < costs.costs.size(); ++i) {
      if (plot.bars.size() == i)
        plot.bars.push_back(
            {fmt::format("{} band{}", costs.costs[i].bands, costs.costs[i].bands == 1 ? "" : "s"),
             {}});
      plot.bars[i].values.push_back(with_range(costs.costs[i].render_seconds, 1.0 / one));
    }
  }
  return plot;
}

LinePlot rel_mse_plot(const ErrorCurves& curves) {
  return error_plot(curves, "relMSE", &ErrorCurve::rel_mse_curve);
}

LinePlot delta_e_plot(const ErrorCurves& curves) {
  return error_plot(curves, "mean dE2000", &ErrorCurve::delta_e_curve);
}

BarPlot plan_plot(const std::vector<SkipCosts>& all) {
  BarPlot plot{"time without a skip over that with all", "times", {}, {}};
  for (const SkipCosts& costs : all) {
    PlotBars bars{costs.scene, {}};
    for (std::size_t i = 1; i < costs.costs.size(); ++i) {
      if (plot.bars.empty()) plot.groups.push_back(costs.costs[i].without);
      bars.values.push_back(with_range(costs.costs[i].ratio));
    }
    plot.bars.push_back(std::move(bars));
  }
  return plot;
}

LinePlot threads_plot(const Scaling& s) {
  PlotLine render{"rendering", {}}, loop{"arithmetic loop", {}}, ideal{"as many as threads", {}};
  for (const ThreadPoint& p : s.threads) {
    const double n = p.threads;
    render.points.push_back({n, with_range(p.speedup)});
    loop.points.push_back({n, with_range(p.loop_speedup)});
    ideal.points.push_back({n, {n}});
  }
  return {fmt::format("{}, {}", s.scene, size_text(s.settings)),
          "threads",
          "wall time on one thread over this",
          Scale::whole,
          Scale::even,
          {render, loop, ideal}};
}

LinePlot sizes_plot(const Scaling& s) {
  return pictures_plot(s, s.sizes, "pixels", [](const RenderSettings& r) {
    return static_cast<double>(r.width) * static_cast<double>(r.height);
  });
}

LinePlot samples_plot(const Scaling& s) {
  return pictures_plot(s, s.samples, "samples per pixel",
                       [](const RenderSettings& r) { return double{1} * r.samples_per_pixel; });
}

LinePlot ray_time_plot(const Scaling& s) {
  return primitives_plot(s, "time per ray", "ns of processor time per ray",
                         [](const PrimitivePoint& p) {
                           return with_range(p.render_seconds, 1e9 / static_cast<double>(p.rays));
                         });
}

LinePlot build_time_plot(const Scaling& s) {
  return primitives_plot(s, "time to build", "processor seconds",
                         [](const PrimitivePoint& p) { return with_range(p.build_seconds); });
}

} // namespace abbe::bench
