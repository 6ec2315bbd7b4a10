#include "core/lights/sun_light.h"
#include "tests/catch.h"
#include "tests/core/lights/goals.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

const SunLight kWide{{0, -1, 0}, 30.0 * pi / 180.0}; // sin = 1/2

} // namespace

TEST_CASE("one direction stands for a sun where it is not sampled") {
  const Illumination i = illumination(kWide, {7, 8, 9});
  CHECK(i.direction == dvec3(0, 1, 0));
  CHECK(i.distance == std::numeric_limits<double>::infinity());
  CHECK(i.strength == 1.0);
}

// A disc of radiance L about the normal gives the irradiance L pi sin^2, which is pi.
TEST_CASE("a sun's disc has the radiance that gives parallel light's irradiance") {
  const auto seen = disc(kWide);
  REQUIRE(seen);
  CHECK(seen->directions.axis == dvec3(0, 1, 0));
  CHECK(seen->directions.solid_angle() ==
        Approx(2.0 * pi * (1.0 - std::sqrt(0.75))).epsilon(1e-14));
  CHECK(seen->radiance == Approx(4.0).epsilon(1e-14));
}

TEST_CASE("a sun counts as bright as its disc, up to 2^20 times its value") {
  CHECK(brightest(kWide, 3.0, 1.0) == Approx(12.0).epsilon(1e-14));
  CHECK(brightest(SunLight{{0, -1, 0}, 1e-4}, 3.0, 1.0) == 3.0 * 0x1p20);
  CHECK(power(kWide, 3.0, 7.0) == Approx(21.0 * pi).epsilon(1e-15));
}

// The disc's flux through a ball is radiance times solid angle times the ball's disc.
TEST_CASE("a sun sends rays from all of its disc") {
  EmissionGoals goals = test::goals({{{3, 0, 1}, 2.0}});
  CHECK(aim(kWide, 3.0, goals) == Approx(3.0 * pi * 4.0 * pi).epsilon(1e-14));
  const double flux = 4.0 * 2.0 * pi * (1.0 - std::sqrt(0.75)) * 4.0 * pi;
  dvec3 mean(0.0);
  constexpr std::uint32_t kCount = 1024;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const auto ray = emit(kWide, goals, Sampler(0, 0, i, 1));
    REQUIRE(ray);
    CHECK(-ray->ray.direction.y > std::sqrt(0.75) - 1e-12);
    CHECK(test::distance_of(ray->ray, {3, 0, 1}) < 2.0 + 1e-12);
    CHECK(ray->flux == Approx(flux).epsilon(1e-13));
    mean += ray->ray.direction / static_cast<double>(kCount);
  }
  // Uniform in solid angle: the mean cosine is halfway from 1 to cos.
  CHECK(mean.y == Approx(-0.5 * (1.0 + std::sqrt(0.75))).epsilon(1e-3));
  CHECK(mean.x == Approx(0.0).margin(1e-2));
  CHECK(mean.z == Approx(0.0).margin(1e-2));
}
