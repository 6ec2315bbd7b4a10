#include "bench/reports/compare.h"
#include "bench/reports/rank_interval.h"
#include "bench/reports/write_json.h"
#include "core/scene/user_error.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;
using namespace abbe::bench;

namespace {

/// A report of one scene with these seconds at 81 bands.
std::string report_text(const std::vector<double>& seconds, const std::string& scene = "lens") {
  Report report;
  report.machine = {"processor", 2, 0.5, "0.1.0", "3.13.5", "GCC", "Release", "x86-64-v3"};
  report.bands.push_back({scene, RenderSettings(), {{81, summary(seconds), summary({1.0}), {}}}});
  return to_json_text(report);
}

Change only_change(const std::vector<double>& before, const std::vector<double>& after) {
  const Comparison comparison = compare(report_text(before), report_text(after), 0.02);
  REQUIRE(comparison.changes.size() == 1);
  return comparison.changes[0];
}

} // namespace

TEST_CASE("the distribution of ranks is that of the orders counted by hand") {
  // Two and two: the six orders have U = 0, 1, 2, 2, 3, 4.
  CHECK(rank_sum_probability(2, 2, 0) == Approx(1.0 / 6.0));
  CHECK(rank_sum_probability(2, 2, 1) == Approx(2.0 / 6.0));
  CHECK(rank_sum_probability(2, 2, 2) == Approx(4.0 / 6.0));
  CHECK(rank_sum_probability(2, 2, 4) == Approx(1.0));
  // One and three: each rank alike.
  CHECK(rank_sum_probability(1, 3, 0) == Approx(0.25));
  CHECK(rank_sum_probability(3, 1, 2) == Approx(0.75));
}

TEST_CASE("critical values of U are those of the published table") {
  // The largest U that is significant at 5 % on two sides.
  struct Critical {
    int n, m, u;
  };
  for (const auto& [n, m, u] : {Critical{4, 4, 0}, Critical{5, 5, 2}, Critical{5, 8, 6},
                                Critical{8, 8, 13}, Critical{10, 10, 23}, Critical{20, 20, 127}}) {
    INFO(n << " and " << m);
    CHECK(2.0 * rank_sum_probability(n, m, u) <= 0.05);
    CHECK(2.0 * rank_sum_probability(n, m, u + 1) > 0.05);
  }
}

TEST_CASE("the interval leaves out as many ratios at each end as the table says") {
  // Ratios 1, 2, 3, 4, 5 times 1, 1/1.1 ...: with five and five, three at each end are left out.
  const std::vector<double> first{1.0, 1.0, 1.0, 1.0, 1.0}, second{1.0, 2.0, 3.0, 4.0, 5.0};
  const auto interval = ratio_interval(first, second, 0.95);
  REQUIRE(interval);
  CHECK(interval->lowest == 1.0); // each ratio stands there five times
  CHECK(interval->highest == 5.0);
  CHECK(interval->confidence == Approx(1.0 - 2.0 * 4.0 / 252.0));
  // Four and four: nothing is left out.
  const auto four = ratio_interval({1.0, 2.0, 4.0, 8.0}, {16.0, 16.0, 16.0, 32.0}, 0.95);
  REQUIRE(four);
  CHECK(four->lowest == 2.0);
  CHECK(four->highest == 32.0);
}

TEST_CASE("too few numbers give no interval") {
  CHECK_FALSE(ratio_interval({1.0, 1.1, 1.2}, {1.0, 1.1, 1.2}, 0.95));
  CHECK(ratio_interval({1.0, 1.1, 1.2}, {1.0, 1.1, 1.2}, 0.89));
  CHECK_FALSE(ratio_interval({}, {1.0}, 0.0));
}

TEST_CASE("a change beyond its noise is told, and noise is not") {
  const std::vector<double> before{1.00, 1.01, 0.99, 1.02, 0.98};
  const auto times = [&](double factor) {
    std::vector<double> after = before;
    for (double& s : after)
      s *= factor;
    return after;
  };
  CHECK(only_change(before, times(1.3)).verdict == Verdict::slower);
  CHECK(only_change(before, times(1.3)).ratio == Approx(1.3));
  CHECK(only_change(before, times(0.7)).verdict == Verdict::faster);
  CHECK(only_change(before, times(1.03)).verdict == Verdict::noise);
  CHECK(only_change(before, before).verdict == Verdict::noise);
  CHECK(only_change({1.0}, {2.0}).verdict == Verdict::too_few);
  // Sure, but less than what two runs may differ by.
  CHECK(only_change({1, 1, 1, 1, 1}, {1.015, 1.015, 1.015, 1.015, 1.015}).verdict ==
        Verdict::noise);
  // Less than a millisecond.
  CHECK(only_change({2e-4, 2e-4, 2e-4, 2e-4}, {9e-4, 9e-4, 9e-4, 9e-4}).verdict == Verdict::noise);
  CHECK(only_change({2e-4, 2e-4, 2e-4, 2e-4}, {2e-3, 2e-3, 2e-3, 2e-3}).verdict == Verdict::slower);
  CHECK(compare(report_text(before), report_text(times(1.3)), 0.02).slower());
  CHECK_FALSE(compare(report_text(before), report_text(times(0.7)), 0.02).slower());
}

TEST_CASE("what is timed in one report only is named, and so are machines") {
  Report other;
  other.machine = {"other", 2, 9.5, "0.1.0", "4.3.0", "GCC", "Release", "x86-64-v3"};
  other.bands.push_back(
      {"lens", RenderSettings(), {{81, summary({1.0}), {}, {}}, {3, {}, {}, {}}}});
  const Comparison c = compare(report_text({1.0}), to_json_text(other), 0.02);
  CHECK(c.changes.size() == 1);
  CHECK(c.only_first.empty());
  REQUIRE(c.only_second.size() == 1);
  CHECK(c.only_second[0].find("3 bands: render") != std::string::npos);
  REQUIRE(c.machine.size() == 2); // the load says nothing of the machine
  CHECK(c.machine[0] == R"(processor: "processor" and "other")");
  CHECK(c.machine[1] == R"(embree: "3.13.5" and "4.3.0")");
  const std::string text = to_text(table_of(c));
  CHECK(text.find("too few repeats") != text.npos);
  CHECK(text.find("only in the second: bands, lens") != text.npos);
}

TEST_CASE("texts that are no reports, or have nothing in common, are refused") {
  const std::string good = report_text({1.0});
  CHECK_THROWS_AS(compare("{", good, 0.02), UserError);
  CHECK_THROWS_AS(compare("{\"machine\": {}}", "[]", 0.02), UserError);
  CHECK_THROWS_AS(compare(good, report_text({1.0}, "prism"), 0.02), UserError);
}
