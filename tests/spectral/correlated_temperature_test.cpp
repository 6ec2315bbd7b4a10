#include "spectral/correlated_temperature.h"

#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/uniform_chromaticity.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

Chromaticity of_light(const Curve& light) {
  return chromaticity(to_xyz(light));
}

/// x, y of CIE 1960 u, v: x = 3u / (2u - 8v + 4), y = 2v / (2u - 8v + 4). [CIE15]
Chromaticity of_uv(double u, double v) {
  const double divisor = 2.0 * u - 8.0 * v + 4.0;
  return {3.0 * u / divisor, 2.0 * v / divisor};
}

} // namespace

TEST_CASE("a radiator has its own temperature, and no distance from the radiators") {
  for (const double kelvin : {1200.0, 2000.0, 2856.0, 5000.0, 6504.0, 10000.0, 25000.0}) {
    const auto found = correlated_temperature(of_light(blackbody(kelvin)));
    REQUIRE(found);
    CHECK(found->kelvin == Approx(kelvin).epsilon(1e-5));
    CHECK(std::abs(found->duv) < 1e-7);
  }
}

TEST_CASE("the CIE's illuminants have their published correlated temperatures") {
  // A is the radiator at 2848 K with the second radiation constant of its time, 1.4350e-2 m K, and
  // so 2855.5 K with that of today; D65 has 6504 K [CIE15]. D65 with its distance and FL2 are as
  // Ohno's method of 2013 gives them (colour-science 0.3, colour/temperature and cfi).
  const auto a = correlated_temperature(of_light(*find_illuminant("A")));
  REQUIRE(a);
  CHECK(a->kelvin == Approx(2855.5).margin(1.0));
  CHECK(std::abs(a->duv) < 2e-5);
  const auto d65 = correlated_temperature(of_light(*find_illuminant("D65")));
  REQUIRE(d65);
  CHECK(d65->kelvin == Approx(6503.5).margin(1.0));
  CHECK(d65->duv == Approx(0.003206).margin(2e-5));
  const auto fl2 = correlated_temperature(of_light(*find_illuminant("FL2")));
  REQUIRE(fl2);
  CHECK(fl2->kelvin == Approx(4224.5).margin(2.0));
  CHECK(fl2->duv == Approx(0.001787).margin(3e-5));
}

TEST_CASE("a chromaticity on the pink side has a distance below 0, one far off no temperature") {
  // The first is u, v = 0.1978, 0.3122: 6507.47 K, 0.00322335 by Ohno's method (colour-science
  // 0.3, whose radiators go from 360 to 830 nm). The second, 1041.68 K and -0.067, is beyond the
  // CIE's limit.
  const auto near = correlated_temperature(of_uv(0.1978, 0.3122));
  REQUIRE(near);
  CHECK(near->kelvin == Approx(6507.5).margin(2.0));
  CHECK(near->duv == Approx(0.003223).margin(2e-5));
  CHECK_FALSE(correlated_temperature(of_uv(0.4328, 0.2883)));
  const auto pink = correlated_temperature(of_uv(0.1978, 0.3022));
  REQUIRE(pink);
  CHECK(pink->duv < -0.002);
  CHECK_FALSE(correlated_temperature({0.3, 0.6}));   // green
  CHECK_FALSE(correlated_temperature({0.15, 0.06})); // blue, beyond all radiators
}

TEST_CASE("u' and v' of the white of sRGB") {
  // 4 x 0.3127 / 6.3226 and 9 x 0.3290 / 6.3226.
  const UniformChromaticity white = uniform({0.3127, 0.3290});
  CHECK(white.u == Approx(0.1978300).margin(5e-7));
  CHECK(white.v == Approx(0.4683200).margin(5e-7));
}
