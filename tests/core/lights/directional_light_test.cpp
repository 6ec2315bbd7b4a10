#include "core/lights/directional_light.h"
#include "tests/catch.h"
#include "tests/core/lights/goals.h"

#include <limits>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

const DirectionalLight kDown{{0, -1, 0}};

} // namespace

TEST_CASE("parallel light comes from infinitely far against its direction") {
  const Illumination i = illumination(kDown, {7, 8, 9});
  CHECK(i.direction == dvec3(0, 1, 0));
  CHECK(i.distance == std::numeric_limits<double>::infinity());
  CHECK(i.strength == 1.0);
}

// Its irradiance is pi times its value.
TEST_CASE("parallel light sends its irradiance through the discs of what it aims at") {
  EmissionGoals goals = test::goals({{{3, 0, 1}, 2.0}});
  CHECK(power(kDown, 3.0, 7.0) == Approx(21.0 * pi).epsilon(1e-15));
  CHECK(aim(kDown, 3.0, goals) == Approx(3.0 * pi * 4.0 * pi).epsilon(1e-14));
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto ray = emit(kDown, goals, Sampler(0, 0, i, 1));
    REQUIRE(ray);
    CHECK(ray->ray.direction == dvec3(0, -1, 0));
    CHECK(ray->ray.origin.y >= 100.0); // before all shapes
    CHECK(test::distance_of(ray->ray, {3, 0, 1}) < 2.0 + 1e-12);
    CHECK(ray->flux == Approx(4.0 * pi * pi).epsilon(1e-14));
  }
}
