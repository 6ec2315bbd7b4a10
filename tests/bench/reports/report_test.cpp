#include "bench/reports/result_tables.h"
#include "bench/reports/write_html.h"
#include "bench/reports/write_json.h"
#include "core/scene/user_error.h"
#include "tests/bench/well_formed.h"
#include "tests/catch.h"

#include <nlohmann/json.hpp>

#include <set>

using namespace abbe;
using namespace abbe::bench;

namespace {

RenderOptions tiny() {
  RenderOptions options;
  options.width = options.height = 16;
  options.samples_per_pixel = 1;
  options.repeats = 1;
  return options;
}

ErrorOptions tiny_error() {
  ErrorOptions options;
  options.render = tiny();
  options.budgets = {1, 2};
  options.reference_samples = 4;
  return options;
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

} // namespace

TEST_CASE("the report has its keys") {
  Report report;
  report.machine = this_machine();
  report.rays.push_back(measure_rays("lens", tiny()));
  report.bands.push_back(measure_bands("sphere", tiny()));
  report.errors.push_back(measure_error("lens", tiny_error(), [](const std::string&) {}));
  report.plans.push_back(measure_plan("newton", tiny()));
  const auto json = nlohmann::json::parse(to_json_text(report));

  for (const char* key :
       {"processor", "threads", "load", "abbe", "embree", "compiler", "build_type", "architecture"})
    CHECK(json.at("machine").contains(key));

  const auto& rays = json.at("rays").at(0);
  CHECK(rays.at("scene") == "lens");
  CHECK(rays.at("settings").at("bands") == 81);
  CHECK(rays.at("settings").at("integrator") == "whitted");
  CHECK(rays.at("settings").at("caustics") == "automatic");
  CHECK(rays.at("render_seconds").contains("median"));
  CHECK(rays.at("render_seconds").at("repeats").size() == 1);
  CHECK(rays.contains("ratio"));
  REQUIRE(rays.at("kinds").size() == 4);
  for (const auto& kind : rays.at("kinds")) {
    CHECK(kind.at("rays") == rays.at("rays").at(kind.at("kind").get<std::string>()));
    for (const char* width : {"1", "4", "8", "16"})
      CHECK(kind.at("replay_seconds").at(width).contains("median"));
    CHECK(kind.contains("query_seconds"));
    CHECK(kind.contains("best_width"));
  }

  const auto& costs = json.at("bands").at(0).at("costs");
  REQUIRE(costs.size() == 5);
  CHECK(costs.at(0).at("bands") == 1);
  CHECK(costs.at(4).at("bands") == 81);

  const auto& error = json.at("error").at(0);
  CHECK(error.at("reference").at("exact") == true);
  CHECK(error.at("reference").at("jitter") == true);
  CHECK(error.at("reference").at("seed") != error.at("curves").at(0).at("settings").at("seed"));
  REQUIRE(error.at("curves").size() == 2);
  for (const auto& curve : error.at("curves")) {
    for (const char* key : {"slope", "seconds_to_1e-2", "seconds_to_1e-3", "seconds_to_1e-4",
                            "seconds_to_mean_delta_e_0.5"})
      CHECK(curve.contains(key));
    for (const auto& budget : curve.at("budgets"))
      for (const char* key : {"samples_per_pixel", "render_seconds", "rel_mse", "rmse_xyz",
                              "mean_delta_e_2000", "delta_e_2000_95"})
        CHECK(budget.contains(key));
  }

  const auto& plan = json.at("plan").at(0);
  CHECK(plan.at("scene") == "newton");
  REQUIRE(plan.at("costs").size() == 6);
  CHECK(plan.at("costs").at(0).at("without") == "nothing");
  CHECK(plan.at("costs").at(5).at("without") == "all skips");
  for (const auto& cost : plan.at("costs")) {
    CHECK(cost.at("changed_pixels") == 0);
    CHECK(cost.at("ratio").contains("lowest"));
  }

  CHECK(mentions(to_text(table_of(report.machine)), report.machine.processor));
  CHECK(mentions(to_text(table_of(report.rays[0])), "refracted"));
  CHECK(mentions(to_text(overview(report.rays)), "lens"));
  CHECK(mentions(to_text(table_of(report.bands[0])), "81"));
  CHECK(mentions(to_text(table_of(report.plans[0])), "empty tiles"));
  CHECK(mentions(to_text(budgets_table(report.errors[0])), "default"));

  const std::vector<Section> sections = sections_of(report);
  REQUIRE(sections.size() == 5); // the machine, and four measurements
  std::set<std::string> names;
  for (const Section& section : sections)
    for (const NamedPlot& plot : section.plots) {
      INFO(plot.name);
      CHECK(names.insert(plot.name).second);
      CHECK(test::xml_mistake(plot.svg).empty());
    }
  CHECK(names == std::set<std::string>{"bands", "colour_difference_lens", "error_lens", "plan",
                                       "rays_lens_81"});
  const std::string page = to_html(sections);
  CHECK(test::xml_mistake(page).empty());
  CHECK(mentions(page, report.machine.processor));
  CHECK_FALSE(mentions(page, "<script"));
  CHECK_FALSE(mentions(page, "href"));
}

TEST_CASE("a page shows the text of its tables, whatever stands in it") {
  const std::string page = to_html({{{{"a < b & c", {"x"}, {{"<1>"}}, {"\"note\""}}}, {}}});
  CHECK(test::xml_mistake(page).empty());
  CHECK(mentions(page, "a &lt; b &amp; c"));
  CHECK(mentions(page, "<td>&lt;1&gt;</td>"));
}

TEST_CASE("plots of one name are told apart") {
  Report report;
  report.scalings.resize(2);
  for (Scaling& s : report.scalings) {
    s.scene = "a scene";
    s.threads.resize(1);
  }
  const std::vector<Section> sections = sections_of(report);
  CHECK(sections[1].plots.at(0).name == "scaling_threads_a_scene");
  CHECK(sections[2].plots.at(0).name == "scaling_threads_a_scene_2");
}

TEST_CASE("default over exact is the ratio of their times to the same colour difference") {
  const auto curve = [](const char* variation, double seconds) {
    ErrorCurve c{{variation, {}}, {}};
    for (const double factor : {1.0, 4.0}) // dE 1, then 0.25: 0.5 is half way in the logarithms
      c.budgets.push_back(
          {1, summary({factor * seconds}), {}, 0, {0.0, 0.0, 1.0 / factor, 0.0, std::nullopt}});
    return c;
  };
  ErrorCurves e{"scene", {}, 0.0, {curve("default", 1.0), curve("exact", 3.0)}};
  CHECK(time_to_error(e.curves[0].delta_e_curve(), kEqualDeltaE).value() == Approx(2.0));
  CHECK(e.default_over_exact().value().mean_delta_e == 0.5);
  CHECK(e.default_over_exact().value().ratio == Approx(1.0 / 3.0));
  CHECK(mentions(to_text(times_table(e)), "at equal error (dE mean 0.5): 0.333"));
  // Where one does not get there, the least that both get to counts: 1, after 1 and 6 seconds.
  e.curves[0].budgets.pop_back();
  e.curves[1].budgets[0].error.mean_delta_e = 4.0; // 4, then 0.25 after four times as long
  CHECK(e.default_over_exact().value().mean_delta_e == 1.0);
  CHECK(e.default_over_exact().value().ratio == Approx(1.0 / 6.0));
  e.curves.pop_back();
  CHECK_FALSE(e.default_over_exact().has_value());
}

TEST_CASE("the reference must not share the scene's seed") {
  ErrorOptions options = tiny_error();
  options.reference_seed = 0;
  CHECK_THROWS_AS(measure_error("lens", options, [](const std::string&) {}), UserError);
}
