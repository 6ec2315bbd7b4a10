#include "core/emitters/illumination.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Light lamp(Falloff falloff, decltype(Light::emitter) emitter) {
  return {"", Curve::constant(1.0), falloff, emitter};
}

/// A spot at the origin that shines along x, full within 10 degrees, dark beyond 30.
const SpotLight kSpot{{0, 0, 0}, {1, 0, 0}, 30.0 * kDegree, 10.0 * kDegree};

double spot_strength(double angle_deg, Falloff falloff = Falloff::none, double distance = 2.0) {
  const double a = angle_deg * kDegree;
  return illumination(lamp(falloff, kSpot), distance * dvec3(std::cos(a), std::sin(a), 0)).strength;
}

} // namespace

// A source of radiant intensity 1 gives the irradiance 1 / d^2, and a diffuse reflectance of 1
// turns irradiance E into the radiance E / pi.
TEST_CASE("light that falls off has the strength 1 / (pi d^2)") {
  const Light light = lamp(Falloff::square, PointLight{{0, 0, 3}});
  for (const double d : {0.5, 1.0, 40.0}) {
    const Illumination i = illumination(light, {d, 0, 3});
    CHECK(i.strength == Approx(1.0 / (std::numbers::pi * d * d)).epsilon(1e-15));
    CHECK(i.distance == d);
    CHECK(i.direction == dvec3(-1, 0, 0));
  }
}

TEST_CASE("the thesis's light is as strong at any distance") {
  const Light light = lamp(Falloff::none, PointLight{{0, 0, 3}});
  CHECK(illumination(light, {0.5, 0, 3}).strength == 1.0);
  CHECK(illumination(light, {4000, 0, 3}).strength == 1.0);
}

TEST_CASE("parallel light comes from infinitely far against its direction") {
  const Illumination i = illumination(lamp(Falloff::none, DirectionalLight{{0, -1, 0}}), {7, 8, 9});
  CHECK(i.direction == dvec3(0, 1, 0));
  CHECK(i.distance == std::numeric_limits<double>::infinity());
  CHECK(i.strength == 1.0);
}

TEST_CASE("a lamp does not light the place where it stands") {
  for (const Falloff falloff : {Falloff::none, Falloff::square})
    CHECK(illumination(lamp(falloff, PointLight{{1, 2, 3}}), {1, 2, 3}).strength == 0.0);
  CHECK(illumination(lamp(Falloff::square, kSpot), {0, 0, 0}).strength == 0.0);
}

// The step 3 x^2 - 2 x^3 over the edge: 1/2 in its middle, 27/32 and 5/32 at its quarters.
TEST_CASE("a spot is full inside its edge, dark outside, and steps smoothly between") {
  CHECK(spot_strength(0.0) == 1.0);
  CHECK(spot_strength(9.99) == 1.0);
  CHECK(spot_strength(15.0) == Approx(27.0 / 32.0).epsilon(1e-12));
  CHECK(spot_strength(20.0) == Approx(0.5).epsilon(1e-12));
  CHECK(spot_strength(25.0) == Approx(5.0 / 32.0).epsilon(1e-12));
  CHECK(spot_strength(30.01) == 0.0);
  CHECK(spot_strength(180.0) == 0.0);
}

TEST_CASE("a spot falls off like a point") {
  CHECK(spot_strength(0.0, Falloff::square, 2.0) == Approx(1.0 / (4.0 * std::numbers::pi)));
  CHECK(spot_strength(20.0, Falloff::square, 2.0) == Approx(0.5 / (4.0 * std::numbers::pi)));
}

TEST_CASE("a spot without a soft edge ends sharply") {
  SpotLight hard = kSpot;
  hard.full_angle = hard.half_angle;
  const auto at = [&](double angle_deg) {
    const double a = angle_deg * kDegree;
    return illumination(lamp(Falloff::none, hard), {std::cos(a), std::sin(a), 0}).strength;
  };
  CHECK(at(29.99) == 1.0);
  CHECK(at(30.01) == 0.0);
}
