#include "bench/measurements/convergence.h"
#include "bench/measurements/timing.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe::bench;

namespace {

// error = 0.1 / seconds, then slower: the fit and the interpolation are known.
const std::vector<TimedError> kHalving{{1.0, 0.1}, {2.0, 0.05}, {8.0, 0.0125}};

} // namespace

TEST_CASE("the slope of a power law is its exponent") {
  CHECK(log_log_slope(kHalving).value() == Approx(-1.0));
  CHECK(log_log_slope({{1.0, 8.0}, {4.0, 4.0}, {16.0, 2.0}}).value() == Approx(-0.5));
}

TEST_CASE("a slope is fitted by least squares") {
  // In powers of e: (0, 0), (1, 1), (2, 0); the mean is (1, 1/3) and xy = 0.
  const double e = std::exp(1.0);
  CHECK(log_log_slope({{1.0, 1.0}, {e, e}, {e * e, 1.0}}).value() == Approx(0.0).margin(1e-12));
}

TEST_CASE("no slope without two times, or with an error of zero") {
  CHECK_FALSE(log_log_slope({}).has_value());
  CHECK_FALSE(log_log_slope({{1.0, 0.1}}).has_value());
  CHECK_FALSE(log_log_slope({{1.0, 0.1}, {1.0, 0.2}}).has_value());
  CHECK_FALSE(log_log_slope({{1.0, 0.1}, {2.0, 0.0}}).has_value());
}

TEST_CASE("time to an error lies on the line between two budgets") {
  CHECK(time_to_error(kHalving, 0.025).value() == Approx(4.0));
  CHECK(time_to_error(kHalving, 0.05).value() == Approx(2.0));
  CHECK(time_to_error(kHalving, 0.0125).value() == Approx(8.0));
}

TEST_CASE("an error met at once takes at most the first budget's time") {
  CHECK(time_to_error(kHalving, 0.2).value() == 1.0);
}

TEST_CASE("an error that the last budget misses is not extrapolated") {
  CHECK_FALSE(time_to_error(kHalving, 0.01).has_value());
  CHECK_FALSE(time_to_error({}, 0.01).has_value());
}

TEST_CASE("a curve that rises again counts from its last miss") {
  const std::vector<TimedError> wavy{{1.0, 0.2}, {2.0, 0.05}, {4.0, 0.2}, {8.0, 0.05}};
  CHECK(time_to_error(wavy, 0.1).value() == Approx(4.0 * std::sqrt(2.0)));
}

TEST_CASE("the median of repeats is the middle one, or between the middle two") {
  CHECK(summary({3.0, 1.0, 2.0}).median == 2.0);
  CHECK(summary({4.0, 1.0, 2.0, 3.0}).median == 2.5);
  CHECK(summary({3.0, 1.0, 2.0}).lowest == 1.0);
  CHECK(summary({3.0, 1.0, 2.0}).highest == 3.0);
  CHECK(summary({3.0, 1.0, 2.0}).repeats == std::vector{3.0, 1.0, 2.0});
  CHECK(summary({}).median == 0.0);
}

TEST_CASE("works take turns, the warm-up is not counted") {
  std::string order;
  const auto runs = interleaved({[&] { order += 'a'; }, [&] { order += 'b'; }}, 2, true);
  CHECK(order == "ababab");
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].wall.size() == 2);
  CHECK(runs[1].cpu.size() == 2);
}
