#pragma once

#include "bench/plots/plot.h"
#include "bench/reports/write_json.h"

namespace abbe::bench {

// What was measured, as plots.

/// Rays per second by kind, beside raw Embree.
[[nodiscard]] BarPlot rays_plot(const RaySpeed& speed);
/// Time at so many bands over that at 1, by scene.
[[nodiscard]] BarPlot bands_plot(const std::vector<BandCosts>& costs);
[[nodiscard]] LinePlot rel_mse_plot(const ErrorCurves& curves);
[[nodiscard]] LinePlot delta_e_plot(const ErrorCurves& curves);
/// Time without each skip over that with all, by scene.
[[nodiscard]] BarPlot plan_plot(const std::vector<SkipCosts>& costs);
[[nodiscard]] LinePlot threads_plot(const Scaling& scaling);
[[nodiscard]] LinePlot sizes_plot(const Scaling& scaling);
[[nodiscard]] LinePlot samples_plot(const Scaling& scaling);
/// Time per ray against the number of primitives.
[[nodiscard]] LinePlot ray_time_plot(const Scaling& scaling);
[[nodiscard]] LinePlot build_time_plot(const Scaling& scaling);

} // namespace abbe::bench
