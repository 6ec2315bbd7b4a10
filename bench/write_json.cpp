#include "bench/write_json.h"

#include <nlohmann/json.hpp>

namespace abbe::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Spread& s) {
  return {
      {"median", s.median}, {"lowest", s.lowest}, {"highest", s.highest}, {"repeats", s.repeats}};
}

Json json(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json(const RayCounts& c) {
  return {{"camera", c.camera}, {"reflected", c.reflected}, {"refracted", c.refracted},
          {"spread", c.spread}, {"shadow", c.shadow},       {"light", c.light}};
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

template <class T>
Json list(const std::vector<T>& results) {
  Json array = Json::array();
  for (const T& result : results)
    array.push_back(json(result));
  return array;
}

} // namespace

std::string to_json_text(const Report& report) {
  const Json result{{"machine", json(report.machine)},
                    {"rays", list(report.rays)},
                    {"bands", list(report.bands)},
                    {"error", list(report.errors)}};
  return result.dump(2) + "\n";
}

} // namespace abbe::bench
