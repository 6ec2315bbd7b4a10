#include "core/optics/fresnel.h"
#include "spectral/color_difference.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/core/bundles/fan_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace abbe;
using test::FanScene;

namespace {

const std::string kBall = "imageSize 512 512 background E 1 tolerance 0\n"
                          "push translate 0 0 -4 scale 9 9 9 square pop glass SF11 sphere\n";
const glm::dvec2 kAside{380.0, 260.0};

/// A ball of dense flint before the border of two colours, so that its rim and the border's image
/// are full of fringes.
Scene fringes(int max_fan, bool exact, const std::string& more) {
  Scene scene = test::scene_from(
      "imageSize 6 6 fieldOfView 20 minThroughput 0 maxRecursionDepth 6 background E 0.2\n"
      "defaultMaterials ambient 0 0 0 diffuse 0 0 0 translate 0 0 -2\n"
      "push emissive 0.9 0.7 0.1 translate -2.1 0 0 scale 2 4 1 square pop\n"
      "push emissive 0.05 0.1 0.6 translate 1.9 0 0 scale 2 4 1 square pop\n"
      "translate 0 0 2 glass SF11 sphere\n" +
      more);
  scene.settings.max_fan = max_fan;
  scene.settings.exact = exact;
  return scene;
}

/// Two-sided quantile of the normal distribution such that all of `tests` independent tests pass
/// with probability 1 - alpha (Sidak).
double sidak_quantile(double alpha, int tests) {
  const double each = 1.0 - std::pow(1.0 - alpha, 1.0 / tests);
  double low = 0.0, high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::numbers::sqrt2) > each ? low : high) = middle;
  }
  return low;
}

} // namespace

TEST_CASE("a path follows no more cells than its share, and each stands for its stratum") {
  for (const int most : {1, 2, 3, 4, 7, 32, 80}) {
    FanScene s(kBall + "maxFan " + std::to_string(most), kAside);
    CAPTURE(most);
    for (const double choice : {0.0, 0.3, 0.999999}) {
      const auto& cells = s.refract(choice);
      CHECK(cells.size() <= static_cast<std::size_t>(most));
      CHECK(2 * cells.size() > static_cast<std::size_t>(most)); // and makes use of it
      for (const FanCell& cell : cells) {
        CHECK(cell.bands.size() == 1);
        CHECK_FALSE(cell.shared);
      }
    }
  }
}

TEST_CASE("a part of the bands has its part of the share") {
  FanScene s(kBall + "maxFan 27", kAside);
  const auto cells = [&](int first, int last) {
    return s.fan.refract(s.bundle, {first, last}, {1.0, 0.5}, s.wavelengths, s.rays).size();
  };
  CHECK(cells(0, 81) <= 27);
  CHECK(cells(0, 9) <= 3);
  CHECK(cells(0, 2) == 1);
  CHECK(cells(40, 41) == 1);
}

// E[weight of band b] = 1: kept with some probability, weighted by its inverse.
TEST_CASE("over all choices every band has the mean weight 1") {
  for (const int most : {1, 4, 7, 32}) {
    FanScene s(kBall + "maxFan " + std::to_string(most), kAside);
    constexpr int kChoices = 81 * 400;
    std::vector<double> mean(81);
    for (int i = 0; i < kChoices; ++i)
      for (const FanCell& cell : s.refract((i + 0.5) / kChoices))
        mean[static_cast<std::size_t>(cell.bands.first)] +=
            static_cast<double>(cell.weight) / kChoices;
    for (const double m : mean)
      CHECK(m == Approx(1.0).margin(0.01));
  }
}

TEST_CASE("tolerance comes before roulette: cells that may be shared are all kept") {
  FanScene s(kBall + "tolerance 1e6 maxFan 1", kAside);
  const auto& cells = s.refract();
  REQUIRE(cells.size() == 1);
  CHECK(cells[0].shared);
  CHECK(cells[0].weight == 1.0f);
}

// Both estimate the same image. Per band, and for Y, the difference of the two means over the image
// is taken for each seed; over the seeds it must be 0 within its own standard error, for all of
// them at once (z-test, Sidak, alpha = 1 %).
TEST_CASE("roulette is unbiased against --exact, band by band") {
  constexpr int kSeeds = 160, kBandCount = 81;
  constexpr std::size_t kLuminance = kBandCount; // the last of the means
  std::vector<double> sum(kBandCount + 1), squares(kBandCount + 1), exact_mean(kBandCount + 1);
  for (int seed = 0; seed < kSeeds; ++seed) {
    const auto image_means = [&](bool exact) {
      Scene scene = fringes(4, exact, "tolerance 0 samples 4");
      scene.settings.seed = static_cast<std::uint64_t>(seed);
      const Film film = test::render_scene(scene, true).film;
      std::vector<double> means(kBandCount + 1);
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x) {
          for (int b = 0; b < kBandCount; ++b)
            means[static_cast<std::size_t>(b)] += film.radiance(x, y, b) / 36.0;
          means[kLuminance] += film.color(x, y).y / 36.0;
        }
      return means;
    };
    const auto exact = image_means(true), roulette = image_means(false);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double difference = roulette[i] - exact[i];
      sum[i] += difference;
      squares[i] += difference * difference;
      exact_mean[i] += exact[i] / kSeeds;
    }
  }
  const double limit = sidak_quantile(0.01, kBandCount + 1);
  CHECK(limit == Approx(3.84).margin(0.02));
  double worst = 0.0;
  std::vector<double> relative_error;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double mean = sum[i] / kSeeds;
    const double error = std::sqrt((squares[i] / kSeeds - mean * mean) / (kSeeds - 1));
    REQUIRE(error > 0.0);
    worst = std::max(worst, std::abs(mean) / error);
    relative_error.push_back(error / exact_mean[i]);
  }
  CHECK(worst < limit);
  // The test has power: a bias of 8 % in Y or of 50 % in a single band would be found.
  CHECK(relative_error[kLuminance] < 0.02);
  CHECK(*std::max_element(relative_error.begin(), relative_error.end()) < 0.13);
}

namespace {

struct Difference {
  double mean = 0.0, worst = 0.0;
};

/// dE2000 over the image between --exact and shared rays, on the same samples, both with jitter.
Difference from_exact(const std::string& tolerance) {
  const auto image = [&](bool exact) {
    return test::render_scene(
               fringes(405, exact, "imageSize 12 12 samples 64 tolerance " + tolerance), false)
        .film;
  };
  const Film exact = image(true), shared = image(false);
  const Xyz white = to_xyz(Curve::constant(1.0));
  Difference result;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      const double de =
          delta_e_2000(to_lab(exact.color(x, y), white), to_lab(shared.color(x, y), white));
      result.mean += de / 144.0;
      result.worst = std::max(result.worst, de);
    }
  return result;
}

} // namespace

// A border of two strong colours through a ball lens, which magnifies what the tolerance lets
// stray: about the worst there is. The mean is what counts, the worst pixel lies on a fringe.
TEST_CASE("the default tolerance costs less than 0.5 dE2000 in the mean and 5 in any pixel") {
  const Difference d = from_exact("0.25");
  INFO("mean " << d.mean << ", worst " << d.worst);
  CHECK(d.mean < 0.5);
  CHECK(d.worst < 5.0);
  CHECK(d.mean > 0.0); // they are different computations
}

TEST_CASE("a tolerance of a fiftieth of a pixel stays below 1 dE2000 in every pixel") {
  const Difference d = from_exact("0.02");
  INFO("mean " << d.mean << ", worst " << d.worst);
  CHECK(d.worst < 1.0);
}
