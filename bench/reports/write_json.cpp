#include "bench/reports/write_json.h"

#include <nlohmann/json.hpp>

namespace abbe::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Summary& s) {
  return {
      {"median", s.median}, {"lowest", s.lowest}, {"highest", s.highest}, {"repeats", s.repeats}};
}

template <class T>
Json json(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json json(const RayCounts& c) {
  return {{"camera", c.camera},       {"reflected", c.reflected}, {"refracted", c.refracted},
          {"scattered", c.scattered}, {"shadow", c.shadow},       {"light", c.light}};
}

Json json(const Machine& m) {
  return {{"processor", m.processor},
          {"threads", m.threads},
          {"load", m.load},
          {"abbe", m.abbe},
          {"embree", m.embree},
          {"compiler", m.compiler},
          {"build_type", m.build_type},
          {"architecture", m.architecture}};
}

Json json(const RenderSettings& s) {
  Json result{{"width", s.width},     {"height", s.height},
              {"bands", s.bands},     {"samples_per_pixel", s.samples_per_pixel},
              {"seed", s.seed},       {"exact", s.exact},
              {"jitter", s.jitter},   {"tolerance_pixels", s.tolerance_pixels},
              {"max_fan", s.max_fan}, {"min_throughput", s.min_throughput},
              {"threads", s.threads}};
  result["integrator"] = s.integrator == Integrator::path ? "path" : "whitted";
  result["caustics"] = s.caustics == Caustics::automatic ? "automatic"
                       : s.caustics == Caustics::on      ? "on"
                                                         : "off";
  result["light_paths"] = s.light_paths;
  result["noise"] = s.noise;
  result["crop"] = s.crop ? Json{s.crop->x0, s.crop->y0, s.crop->x1, s.crop->y1} : Json();
  return result;
}

Json json(const KindSpeed& k) {
  Json replay = Json::object();
  for (std::size_t i = 0; i < kPacketWidths.size(); ++i)
    replay[std::to_string(kPacketWidths[i])] = json(k.replay_seconds[i]);
  return {{"kind", name(k.kind)},
          {"rays", k.rays},
          {"any_hit", k.any_hit},
          {"replay_seconds", replay},
          {"best_width", k.best_width()},
          {"best_replay_seconds", k.best_replay_seconds()},
          {"query_seconds", json(k.query_seconds)},
          {"ratio", k.best_replay_seconds() / k.query_seconds.median}};
}

Json json(const RaySpeed& r) {
  Json kinds = Json::array();
  for (const KindSpeed& kind : r.kinds)
    kinds.push_back(json(kind));
  return {{"scene", r.scene},
          {"settings", json(r.settings)},
          {"render_seconds", json(r.render_seconds)},
          {"render_wall_seconds", json(r.render_wall_seconds)},
          {"rays", json(r.counts)},
          {"kinds", kinds},
          {"best_replay_seconds", r.best_replay_seconds()},
          {"ratio", r.ratio()}};
}

Json json(const BandCosts& c) {
  Json costs = Json::array();
  for (const BandCost& cost : c.costs)
    costs.push_back({{"bands", cost.bands},
                     {"render_seconds", json(cost.render_seconds)},
                     {"render_wall_seconds", json(cost.wall_seconds)},
                     {"rays", json(cost.counts)}});
  return {{"scene", c.scene}, {"settings", json(c.settings)}, {"costs", costs}};
}

Json json(const BudgetError& b) {
  return {{"samples_per_pixel", b.samples},
          {"render_seconds", json(b.render_seconds)},
          {"render_wall_seconds", json(b.wall_seconds)},
          {"rays", b.rays},
          {"rel_mse", b.error.rel_mse},
          {"rmse_xyz", b.error.rmse_xyz},
          {"band_noise", json(b.error.band_noise)},
          {"mean_delta_e_2000", b.error.mean_delta_e},
          {"delta_e_2000_95", b.error.delta_e_95}};
}

Json json(const ErrorCurve& c) {
  Json budgets = Json::array();
  for (const BudgetError& budget : c.budgets)
    budgets.push_back(json(budget));
  const std::vector<TimedError> points = c.rel_mse_curve();
  return {{"variation", c.variation.name},
          {"settings", json(c.variation.settings)},
          {"budgets", budgets},
          {"slope", json(log_log_slope(points))},
          {"seconds_to_1e-2", json(time_to_error(points, 1e-2))},
          {"seconds_to_1e-3", json(time_to_error(points, 1e-3))},
          {"seconds_to_1e-4", json(time_to_error(points, 1e-4))},
          {"seconds_to_mean_delta_e_0.5", json(time_to_error(c.delta_e_curve(), kEqualDeltaE))}};
}

Json json(const std::optional<EqualError>& e) {
  return e ? Json{{"mean_delta_e_2000", e->mean_delta_e}, {"ratio", e->ratio}} : Json();
}

Json json(const ErrorCurves& e) {
  Json curves = Json::array();
  for (const ErrorCurve& curve : e.curves)
    curves.push_back(json(curve));
  return {{"scene", e.scene},
          {"reference", json(e.reference)},
          {"reference_seconds", e.reference_seconds},
          {"curves", curves},
          {"default_over_exact_at_equal_error", json(e.default_over_exact())}};
}

Json json(const SkipCost& c) {
  return {{"without", c.without},
          {"render_seconds", json(c.render_seconds)},
          {"render_wall_seconds", json(c.wall_seconds)},
          {"ratio", json(c.ratio)},
          {"changed_pixels", c.changed_pixels}};
}

Json json(const SkipCosts& c) {
  Json costs = Json::array();
  for (const SkipCost& cost : c.costs)
    costs.push_back(json(cost));
  return {{"scene", c.scene},           {"settings", json(c.settings)},
          {"tiles", c.tiles},           {"empty_tiles", c.empty_tiles},
          {"dead_bands", c.dead_bands}, {"costs", costs}};
}

Json json(const ThreadPoint& p) {
  return {{"threads", p.threads},
          {"render_wall_seconds", json(p.wall_seconds)},
          {"render_seconds", json(p.render_seconds)},
          {"loop_wall_seconds", json(p.loop_wall_seconds)},
          {"speedup", json(p.speedup)},
          {"loop_speedup", json(p.loop_speedup)},
          {"share_of_loop", p.share_of_loop()}};
}

Json json(const ImagePoint& p) {
  return {{"width", p.settings.width},
          {"height", p.settings.height},
          {"samples_per_pixel", p.settings.samples_per_pixel},
          {"render_seconds", json(p.render_seconds)},
          {"render_wall_seconds", json(p.wall_seconds)},
          {"rays", p.rays},
          {"film_bytes", json(p.film_bytes)},
          {"band_film_bytes", json(p.band_film_bytes)}};
}

Json json(const PrimitivePoint& p) {
  return {{"primitives", p.primitives},
          {"build_seconds", json(p.build_seconds)},
          {"build_wall_seconds", json(p.build_wall_seconds)},
          {"render_seconds", json(p.render_seconds)},
          {"render_wall_seconds", json(p.wall_seconds)},
          {"rays", p.rays},
          {"bytes", json(p.bytes)}};
}

Json json(const Scaling& s);

template <class T>
Json list(const std::vector<T>& results) {
  Json array = Json::array();
  for (const T& result : results)
    array.push_back(json(result));
  return array;
}

Json json(const Scaling& s) {
  return {{"scene", s.scene},
          {"settings", json(s.settings)},
          {"by_threads", list(s.threads)},
          {"by_size", list(s.sizes)},
          {"by_samples", list(s.samples)},
          {"by_triangles", list(s.triangles)},
          {"by_lenses", list(s.lenses)}};
}

} // namespace

std::string to_json_text(const Report& report) {
  const Json result{{"machine", json(report.machine)}, {"rays", list(report.rays)},
                    {"bands", list(report.bands)},     {"error", list(report.errors)},
                    {"plan", list(report.plans)},      {"scaling", list(report.scalings)}};
  return result.dump(2) + "\n";
}

} // namespace abbe::bench
