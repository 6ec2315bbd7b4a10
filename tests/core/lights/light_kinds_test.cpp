#include "core/lights/light_kinds.h"
#include "tests/catch.h"
#include "tests/core/lights/goals.h"

#include <cmath>
#include <numbers>
#include <vector>

using namespace abbe;

namespace {

using std::numbers::pi;

/// A light of each kind and what its visits answer, by closed forms: for a value of 2, a disc of
/// the area 5 about the scene, the nearest place at 0.5, and a point 2 below the origin.
struct Expected {
  LightKind kind;
  bool has_position, has_disc;
  double strength, power, brightest;
  bool endless;
  double flux, emitted; ///< towards a ball of radius 1, at 2 below the origin
};

const double kBall = 2.0 * pi * (1.0 - std::sqrt(0.75));             // sin = 1/2
const double kCone = 2.0 * pi * (1.0 - std::cos(60.0 * pi / 180.0)); // wider than the ball

std::vector<Expected> expected() {
  const dvec3 down(0, 0, -1);
  const double angle = 60.0 * pi / 180.0, radius = 30.0 * pi / 180.0;
  return {
      {PointLight{{0, 0, 0}, Falloff::none}, true, false, 1.0, 10.0 * pi, 2.0, true, 2.0 * kBall,
       kBall},
      {PointLight{{0, 0, 0}, Falloff::square}, true, false, 0.25 / pi, 8.0 * pi, 8.0, false,
       2.0 * kBall, kBall},
      {DirectionalLight{down}, false, false, 1.0, 10.0 * pi, 2.0, false, 2.0 * pi * pi, pi * pi},
      {SpotLight{{0, 0, 0}, down, angle, angle, Falloff::none}, true, false, 1.0, 10.0 * pi, 2.0,
       true, 2.0 * kBall, kBall},
      {SpotLight{{0, 0, 0}, down, angle, angle, Falloff::square}, true, false, 0.25 / pi,
       2.0 * kCone, 8.0, false, 2.0 * kBall, kBall},
      {SunLight{down, radius}, false, true, 1.0, 10.0 * pi, 8.0, false, 2.0 * pi * pi,
       4.0 * kBall * pi},
  };
}

} // namespace

TEST_CASE("each kind of light answers each question") {
  std::vector<bool> met(std::variant_size_v<LightKind>, false);
  for (const Expected& e : expected()) {
    CAPTURE(e.kind.index(), e.endless);
    met[e.kind.index()] = true;
    const Light light{"", Curve::constant(1.0), e.kind};
    CHECK(position(light).has_value() == e.has_position);
    if (e.has_position) CHECK(position(light) == dvec3(0, 0, 0));
    CHECK(disc(light).has_value() == e.has_disc);
    const Illumination seen = illumination(light, {0, 0, -2});
    CHECK(seen.direction == dvec3(0, 0, 1));
    CHECK(std::isinf(seen.distance) == !e.has_position);
    CHECK(seen.strength == Approx(e.strength).epsilon(1e-14));
    CHECK(power(light, 2.0, 5.0) == Approx(e.power).epsilon(1e-14));
    CHECK(brightest(light, 2.0, 0.5) == Approx(e.brightest).epsilon(1e-14));
    CHECK(endless_flux(light) == e.endless);
    EmissionGoals goals = test::goals({{{0, 0, -2}, 1.0}});
    CHECK(aim(light, 2.0, goals) == Approx(e.flux).epsilon(1e-14));
    const auto ray = emit(light, goals, Sampler(0, 0, 0, 1));
    REQUIRE(ray);
    CHECK(test::distance_of(ray->ray, {0, 0, -2}) < 1.0 + 1e-12);
    CHECK(ray->flux == Approx(e.emitted).epsilon(1e-13));
  }
  for (const bool kind_is_met : met)
    CHECK(kind_is_met);
}
