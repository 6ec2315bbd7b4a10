#include "io/building/light_units.h"

#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace abbe;
using std::numbers::pi;

namespace {

/// The Y of a light of this kind and strength.
double value_of(const LightKind& kind, const Curve& spectrum, LightUnit unit, double amount,
                double mm_per_unit = 1000.0) {
  Light light{"lamp", spectrum, kind, ""};
  set_strength({"s.sdl", 1, 1}, light, {amount, unit}, mm_per_unit);
  return to_xyz(light.spectrum).y;
}

} // namespace

TEST_CASE("candela and lumen of a point are in the ratio of the whole sphere") {
  const Curve d65 = *find_illuminant("D65");
  CHECK(value_of(PointLight{}, d65, LightUnit::candela, 60.0) == Approx(60.0));
  CHECK(value_of(PointLight{}, d65, LightUnit::lumen, 800.0) == Approx(800.0 / (4.0 * pi)));
  // In a scene in mm, 1 m away is 1000 units away.
  CHECK(value_of(PointLight{}, d65, LightUnit::candela, 60.0, 1.0) == Approx(60e6));
  CHECK(value_of(PointLight{}, d65.scaled(7.0), LightUnit::factor, 2.0) == Approx(14.0));
}

TEST_CASE("the lumens of a spot are those of its cone") {
  const Curve d65 = *find_illuminant("D65");
  const double half = 20.0 * pi / 180.0;
  CHECK(value_of(SpotLight{{}, {0, 0, -1}, half, half, Falloff::none}, d65, LightUnit::lumen,
                 800.0) == Approx(800.0 / (2.0 * pi * (1.0 - std::cos(half)))));
  // A small cone that is all edge: h^2 times the integral of (3 x^2 - 2 x^3) (1 - x), 3/20.
  const double small = 1e-3;
  const double value =
      value_of(SpotLight{{}, {0, 0, -1}, small, 0.0, Falloff::none}, d65, LightUnit::lumen, 1.0);
  CHECK(value == Approx(1.0 / (2.0 * pi * small * small * 0.15)).epsilon(1e-5));
}

TEST_CASE("a watt is as many lumens as the standard observer sees") {
  // 683 times y(lambda) and the integrals over 5 nm of the CIE's tables, computed apart.
  const auto lumens = [](const Curve& spectrum) {
    return value_of(PointLight{}, spectrum, LightUnit::watt, 1.0) * 4.0 * pi;
  };
  CHECK(lumens(*find_illuminant("A")) == Approx(156.194).epsilon(1e-3));
  CHECK(lumens(*find_illuminant("D65")) == Approx(205.156).epsilon(1e-3));
  CHECK(lumens(Curve::lines({{632.8, 1.0}})) == Approx(162.04).epsilon(2e-3));
}

TEST_CASE("lux are of parallel light, and fluxes are not") {
  const Curve d65 = *find_illuminant("D65");
  CHECK(value_of(DirectionalLight{}, d65, LightUnit::lux, 100.0) == Approx(100.0 / pi));
  CHECK(value_of(SunLight{}, d65, LightUnit::lux, 100.0) == Approx(100.0 / pi));
  CHECK_THROWS_WITH(value_of(SunLight{}, d65, LightUnit::lumen, 1.0),
                    Catch::Matchers::ContainsSubstring("lumen does not go with this light"));
  CHECK_THROWS_WITH(value_of(PointLight{}, d65, LightUnit::lux, 1.0),
                    Catch::Matchers::ContainsSubstring("lux does not go with this light"));
}

TEST_CASE("a light in units of lamps falls off with distance squared") {
  Light light{"lamp", *find_illuminant("D65"), PointLight{}, ""};
  set_strength({"s.sdl", 1, 1}, light, {1.0, LightUnit::lumen}, 1000.0);
  CHECK(std::get<PointLight>(light.kind).falloff == Falloff::square);
}
