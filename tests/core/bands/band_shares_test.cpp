#include "core/bands/band_shares.h"
#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numeric>
#include <vector>

using namespace abbe;

namespace {

/// What the bands count: nothing at the ends, a gap, and a peak.
const std::vector<double> kSeen{0.0, 0.001, 1.0, 8.0, 0.0, 27.0, 8.0, 1.0, 0.0};
// Cube roots 0, 0.1, 1, 2, 0, 3, 2, 1, 0: the second is raised to a quarter of the mean.
const double kLeast = 0.25 * 9.1 / 6.0, kSum = 9.0 + kLeast;

} // namespace

TEST_CASE("shares go as the cube root of what is seen, and no live band is left out") {
  const BandShares shares(kSeen);
  const std::vector<double> expected{0.0, kLeast, 1.0, 2.0, 0.0, 3.0, 2.0, 1.0, 0.0};
  for (int b = 0; b < 9; ++b)
    CHECK(shares.of({b, b + 1}) == Approx(expected[static_cast<std::size_t>(b)] / kSum));
  CHECK(shares.of({0, 9}) == Approx(1.0));
  CHECK(shares.of({3, 3}) == 0.0);
}

TEST_CASE("a range is halved at the border nearest to half of its share") {
  const BandShares shares(kSeen);
  CHECK(shares.middle({0, 9}) == 5); // 3.38 before and 6 behind are nearer than 6.38 and 3
  CHECK(shares.middle({5, 8}) == 6); // 3 and 3
  CHECK(shares.middle({2, 4}) == 3);
  CHECK(shares.middle({0, 2}) == 1); // neither side is empty, whatever the bands count
  CHECK(shares.place({5, 8}, 0.9) == 7);
}

TEST_CASE("each band is kept in proportion to its share, with the weight that makes up for it") {
  const BandShares shares(kSeen);
  for (const BandRange range : {BandRange{0, 9}, {1, 6}, {5, 8}, {2, 3}}) {
    std::vector<double> mean(9);
    constexpr int kNumbers = 100000;
    for (int i = 0; i < kNumbers; ++i) {
      const auto [band, weight] = shares.keep_one(range, (i + 0.5) / kNumbers);
      mean[static_cast<std::size_t>(band)] += static_cast<double>(weight) / kNumbers;
    }
    for (int b = 0; b < 9; ++b) {
      const bool kept =
          b >= range.first && b < range.last && kSeen[static_cast<std::size_t>(b)] > 0.0;
      CHECK(mean[static_cast<std::size_t>(b)] == Approx(kept ? 1.0 : 0.0).margin(1e-3));
    }
  }
  CHECK(shares.keep_one({0, 9}, 0.0).band == 1); // the first that carries light
  CHECK(shares.keep_one({0, 9}, std::nextafter(1.0, 0.0)).band == 7);
}

// In equal-energy light the ends of the spectrum count 1e-5 of the middle.
TEST_CASE("a plan's shares follow from the observer and the lights") {
  const Scene scene = test::scene_from("background E 1 sphere");
  const Plan plan = make_plan(scene, scene.settings);
  const auto share = [&](int b) { return plan.shares.of({b, b + 1}); };
  CHECK(share(80) == Approx(share(79))); // both at the least share
  CHECK(share(35) > 1.2 / 81.0);
  CHECK(share(80) < 0.3 / 81.0);
  const Scene lines = test::scene_from("background sodium 1 sphere");
  const Plan of_lines = make_plan(lines, lines.settings);
  for (int b = 0; b < 81; ++b)
    CHECK((of_lines.shares.of({b, b + 1}) > 0.0) ==
          (of_lines.live[static_cast<std::size_t>(b)] > 0.0f));
}

namespace {

/// The mean relative variance of X, Y and Z of white light when a sample keeps one band of each of
/// `parts` ranges, which are made by halving.
double color_noise(const Plan& plan, int parts) {
  std::vector<BandRange> ranges{{0, 81}};
  while (static_cast<int>(ranges.size()) < parts) {
    const BandRange r = ranges.front();
    const int middle = plan.shares.middle(r);
    ranges.erase(ranges.begin());
    ranges.push_back({r.first, middle});
    ranges.push_back({middle, r.last});
  }
  const AccumulatorPlan& seen = plan.accumulators.front();
  double noise = 0.0;
  for (const auto* weights : {&seen.x, &seen.y, &seen.z}) {
    const double sum = std::accumulate(weights->begin(), weights->end(), 0.0);
    constexpr int kNumbers = 4096;
    for (int i = 0; i < kNumbers; ++i) {
      double kept = 0.0;
      for (const BandRange r : ranges) {
        const auto [band, weight] = plan.shares.keep_one(r, (i + 0.5) / kNumbers);
        kept += static_cast<double>(weight * (*weights)[static_cast<std::size_t>(band)]);
      }
      noise += std::pow(kept / sum - 1.0, 2) / kNumbers / 3.0;
    }
  }
  return noise;
}

} // namespace

// With bands at equal distances the variance is 0.19 for four of 81 bands and 0.004 for eight
// [docs/decisions/bundles.md].
TEST_CASE("a few bands, chosen by share, give the colour of white light nearly without noise") {
  const Scene scene = test::scene_from("background D65 1 sphere");
  const Plan plan = make_plan(scene, scene.settings);
  CHECK(color_noise(plan, 8) < 0.002);
  CHECK(color_noise(plan, 4) < 0.02);
}
