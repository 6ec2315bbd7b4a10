#include "core/drops/disc_blur.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>
#include <numeric>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi;

/// The same by counting: the spot's points, on rings and spokes of equal area.
double counted_share(double radius, double distance, double reach) {
  constexpr int kRings = 800, kSpokes = 800;
  int within = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double c = 1.0 - (1.0 - std::cos(radius)) * (ring + 0.5) / kRings;
    const double s = std::sqrt(1.0 - c * c);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double turn = 2.0 * kPi * (spoke + 0.5) / kSpokes;
      const double height = std::cos(distance) * c + std::sin(distance) * s * std::cos(turn);
      if (height > std::cos(reach)) ++within;
    }
  }
  return within / double(kRings * kSpokes);
}

} // namespace

TEST_CASE("the share of a spot within reach of the pole is what counting finds") {
  struct Case {
    double radius, distance, reach;
  };
  for (const Case& c :
       {Case{0.3, 1.0, 0.9}, Case{0.3, 1.0, 1.0}, Case{0.3, 1.0, 1.25}, Case{0.3, 0.1, 0.15},
        Case{0.3, 0.1, 0.25}, Case{0.3, 0.1, 0.39}, Case{0.3, 2.4, 2.5}, Case{0.3, 3.0, 3.05},
        Case{0.3, 3.1, 3.0}, Case{0.05, 0.7, 0.68}, Case{0.3, 0.0, 0.2}})
    CHECK(cap_share(c.radius, c.distance, c.reach) ==
          Approx(counted_share(c.radius, c.distance, c.reach)).margin(3e-3));
}

TEST_CASE("a spot is all or not at all within reach when it does not touch the border") {
  CHECK(cap_share(0.1, 1.0, 1.1) == 1.0);
  CHECK(cap_share(0.1, 1.0, 0.9) == 0.0);
  CHECK(cap_share(0.1, kPi / 2.0, kPi / 2.0) == Approx(0.5).epsilon(1e-12));
  CHECK(cap_share(0.1, 3.0, kPi) == 1.0);
  // Around the pole, areas go as 1 - cos.
  CHECK(cap_share(0.1, 0.0, 0.05) ==
        Approx((1.0 - std::cos(0.05)) / (1.0 - std::cos(0.1))).epsilon(1e-9));
}

TEST_CASE("blurred flux is spread by the disc's width and none is lost") {
  constexpr std::size_t kCells = 3600;
  const double cell = kPi / kCells, radius = 5.0 * cell;
  const DiscBlur blur(kCells, radius);
  for (const std::size_t source : {std::size_t{0}, std::size_t{3}, std::size_t{1800}, kCells - 1}) {
    std::vector<double> flux(kCells);
    flux[source] = 2.0;
    blur.apply(flux);
    CHECK(std::accumulate(flux.begin(), flux.end(), 0.0) == Approx(2.0).epsilon(1e-12));
    for (std::size_t j = 0; j < kCells; ++j)
      if (j + 6 < source || j > source + 6) CHECK(flux[j] == 0.0);
    CHECK(flux[source] < 1.0);
  }
}

// Far from the poles a disc of radius a, cut at x from its centre, has a share of
// 1/2 + (asin(x / a) + x / a sqrt(1 - (x / a)^2)) / pi on one side.
TEST_CASE("across the equator a disc is spread as its chords are") {
  constexpr std::size_t kCells = 36000; // so that the source is narrow beside the disc
  const double cell = kPi / kCells, radius = 100.0 * cell;
  std::vector<double> flux(kCells);
  flux[kCells / 2 - 1] = flux[kCells / 2] = 0.5;
  DiscBlur(kCells, radius).apply(flux);
  for (const int x : {-60, 0, 30, 90}) {
    const double u = x / 100.0;
    const double expected = 0.5 + (std::asin(u) + u * std::sqrt(1.0 - u * u)) / kPi;
    CHECK(std::accumulate(flux.begin(), flux.begin() + kCells / 2 + x, 0.0) ==
          Approx(expected).margin(1e-4));
  }
}

TEST_CASE("a disc of radius 0 leaves flux where it is") {
  std::vector<double> flux{1.0, 2.0, 3.0};
  DiscBlur(3, 0.0).apply(flux);
  CHECK(flux == std::vector<double>{1.0, 2.0, 3.0});
}
