#include "core/lights/point_light.h"
#include "tests/catch.h"
#include "tests/core/lights/goals.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

const PointLight kSteady{{0, 0, 3}, Falloff::none};
const PointLight kFalling{{0, 0, 3}, Falloff::square};

} // namespace

// A source of radiant intensity 1 gives the irradiance 1 / d^2, and a diffuse reflectance of 1
// turns irradiance E into the radiance E / pi.
TEST_CASE("light that falls off has the strength 1 / (pi d^2)") {
  for (const double d : {0.5, 1.0, 40.0}) {
    const Illumination i = illumination(kFalling, {d, 0, 3});
    CHECK(i.strength == Approx(1.0 / (pi * d * d)).epsilon(1e-15));
    CHECK(i.distance == d);
    CHECK(i.direction == dvec3(-1, 0, 0));
  }
}

TEST_CASE("the thesis's light is as strong at any distance") {
  CHECK(illumination(kSteady, {0.5, 0, 3}).strength == 1.0);
  CHECK(illumination(kSteady, {4000, 0, 3}).strength == 1.0);
}

TEST_CASE("a point does not light the place where it stands") {
  CHECK(illumination(kSteady, {0, 0, 3}).strength == 0.0);
  CHECK(illumination(kFalling, {0, 0, 3}).strength == 0.0);
}

// An intensity of 1 to all sides is 4 pi; an irradiance of pi goes through the disc.
TEST_CASE("the power of a point is its flux, or that through the disc about the scene") {
  CHECK(power(kFalling, 3.0, 7.0) == Approx(12.0 * pi).epsilon(1e-15));
  CHECK(power(kSteady, 3.0, 7.0) == Approx(21.0 * pi).epsilon(1e-15));
}

TEST_CASE("a point that falls off counts as bright as it is at the nearest place") {
  CHECK(brightest(kFalling, 3.0, 0.5) == 12.0);
  CHECK(brightest(kFalling, 3.0, 0.0) == 0.0);
  CHECK(brightest(kSteady, 3.0, 0.5) == 3.0);
}

// The ball fills sin = 1/2: 2 pi (1 - sqrt(3)/2).
TEST_CASE("a point sends its rays into the solid angles of what it aims at") {
  EmissionGoals goals = test::goals({{{0, 0, 1}, 1.0}});
  const double angle = 2.0 * pi * (1.0 - std::sqrt(0.75));
  CHECK(aim(kFalling, 3.0, goals) == Approx(3.0 * angle).epsilon(1e-14));
  CHECK(goals.targets.size() == 1);
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto ray = emit(kFalling, goals, Sampler(0, 0, i, 1));
    REQUIRE(ray);
    CHECK(ray->ray.origin == dvec3(0, 0, 3));
    CHECK(ray->ray.direction.z < 0.0);
    CHECK(test::distance_of(ray->ray, {0, 0, 1}) < 1.0 + 1e-12);
    CHECK(ray->flux == Approx(angle).epsilon(1e-14));
  }
}
