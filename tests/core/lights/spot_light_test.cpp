#include "core/lights/spot_light.h"
#include "tests/catch.h"
#include "tests/core/lights/goals.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

constexpr double kDegree = pi / 180.0;

/// A spot at the origin that shines along x, full within 10 degrees, dark beyond 30.
SpotLight spot(Falloff falloff = Falloff::none) {
  return {{0, 0, 0}, {1, 0, 0}, 30.0 * kDegree, 10.0 * kDegree, falloff};
}

double strength(const SpotLight& light, double angle_deg, double distance = 2.0) {
  const double a = angle_deg * kDegree;
  return illumination(light, distance * dvec3(std::cos(a), std::sin(a), 0)).strength;
}

} // namespace

// The step 3 x^2 - 2 x^3 over the edge: 1/2 in its middle, 27/32 and 5/32 at its quarters.
TEST_CASE("a spot is full inside its edge, dark outside, and steps smoothly between") {
  CHECK(strength(spot(), 0.0) == 1.0);
  CHECK(strength(spot(), 9.99) == 1.0);
  CHECK(strength(spot(), 15.0) == Approx(27.0 / 32.0).epsilon(1e-12));
  CHECK(strength(spot(), 20.0) == Approx(0.5).epsilon(1e-12));
  CHECK(strength(spot(), 25.0) == Approx(5.0 / 32.0).epsilon(1e-12));
  CHECK(strength(spot(), 30.01) == 0.0);
  CHECK(strength(spot(), 180.0) == 0.0);
}

TEST_CASE("a spot falls off like a point") {
  CHECK(strength(spot(Falloff::square), 0.0) == Approx(1.0 / (4.0 * pi)));
  CHECK(strength(spot(Falloff::square), 20.0) == Approx(0.5 / (4.0 * pi)));
}

TEST_CASE("a spot without a soft edge ends sharply") {
  SpotLight hard = spot();
  hard.full_angle = hard.half_angle;
  CHECK(strength(hard, 29.99) == 1.0);
  CHECK(strength(hard, 30.01) == 0.0);
}

TEST_CASE("a spot does not light the place where it stands") {
  CHECK(illumination(spot(Falloff::square), {0, 0, 0}).strength == 0.0);
}

// Half of the soft edge counts: a cone of 20 degrees, 2 pi (1 - cos) of solid angle.
TEST_CASE("the power of a spot is that of its cone") {
  const double cone = 2.0 * pi * (1.0 - std::cos(20.0 * kDegree));
  CHECK(power(spot(Falloff::square), 3.0, 7.0) == Approx(3.0 * cone).epsilon(1e-14));
  // Of the irradiance 3 pi over the disc about the scene a narrow cone has as much less as it is
  // narrower than a half space's projected solid angle, pi.
  CHECK(power(spot(), 3.0, 7.0) == Approx(3.0 * pi * 7.0 * cone / pi).epsilon(1e-14));
  SpotLight wide = spot();
  wide.half_angle = wide.full_angle = 80.0 * kDegree;
  CHECK(power(wide, 3.0, 7.0) == Approx(3.0 * pi * 7.0).epsilon(1e-14));
}

TEST_CASE("a spot aims at what its cone reaches alone") {
  EmissionGoals goals = test::goals({{{5, 0, 0}, 1.0}, {{-5, 0, 0}, 1.0}, {{0, 5, 0}, 1.0}});
  // sin = 1/5, less than the cone of 30 degrees.
  const double ball = 2.0 * pi * (1.0 - std::sqrt(24.0 / 25.0));
  CHECK(aim(spot(Falloff::square), 2.0, goals) == Approx(2.0 * ball).epsilon(1e-14));
  REQUIRE(goals.targets.size() == 1);
  CHECK(goals.targets[0].center == dvec3(5, 0, 0));
  // A ball that fills more than the cone gets what the cone holds.
  EmissionGoals near = test::goals({{{1.5, 0, 0}, 1.0}});
  CHECK(aim(spot(Falloff::square), 2.0, near) ==
        Approx(4.0 * pi * (1.0 - std::cos(30.0 * kDegree))).epsilon(1e-14));
}

TEST_CASE("rays of a spot are as strong as it is bright in their direction") {
  const double ball = 2.0 * pi * (1.0 - std::sqrt(24.0 / 25.0));
  // Seen at 20 degrees, half bright in its middle; its edges are full and dark.
  const double angle = 20.0 * kDegree;
  const EmissionGoals goals =
      test::goals({{5.0 * dvec3(std::cos(angle), std::sin(angle), 0.0), 1.0}});
  int none = 0;
  for (std::uint32_t i = 0; i < 256; ++i) {
    const auto ray = emit(spot(Falloff::square), goals, Sampler(0, 0, i, 1));
    if (!ray) {
      ++none;
      continue;
    }
    CHECK(ray->ray.origin == dvec3(0, 0, 0));
    const double a = std::acos(ray->ray.direction.x) / kDegree;
    const double x = std::min((30.0 - a) / 20.0, 1.0);
    CHECK(ray->flux == Approx(ball * x * x * (3.0 - 2.0 * x)).epsilon(1e-6));
  }
  CHECK(none > 0); // beyond the cone
  CHECK(none < 64);
}
