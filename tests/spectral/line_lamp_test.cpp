#include "spectral/line_lamp.h"

#include "spectral/observer.h"
#include "tests/catch.h"

#include <cmath>
#include <stdexcept>

using namespace abbe;

TEST_CASE("A line has the colour of its wavelength and Y = 1 in any bands") {
  for (const int bands : {1, 3, 9, 27, 81, 200, 405}) {
    INFO(bands);
    Xyz sum;
    int bands_lit = 0;
    for (const Xyz& weight : band_weights(BandGrid(bands), line_lamp(520.0))) {
      sum += weight;
      if (weight.y > 0.0) ++bands_lit;
    }
    CHECK(bands_lit == 1);
    CHECK(sum.y == Approx(1.0).epsilon(1e-12));
    // xbar 0.06327, ybar 0.710, zbar 0.07825 at 520 nm [CIE018].
    CHECK(sum.x == Approx(0.06327 / 0.710).epsilon(1e-3));
    CHECK(sum.z == Approx(0.07825 / 0.710).epsilon(1e-3));
  }
}

TEST_CASE("Power per band is spread over the band") {
  const Curve line = line_lamp(632.8);
  const double power = line.spectral_lines()[0].power;
  const auto means = band_means(BandGrid(81), line);
  CHECK(means[51] == Approx(power / 5.0)); // 632.5-637.5 nm
  CHECK(means[50] == 0.0);
  CHECK(band_means(BandGrid(1), line)[0] == Approx(power / 405.0));
}

TEST_CASE("Sodium is orange-yellow, its lines two to one") {
  const Curve lamp = sodium_lamp();
  REQUIRE(lamp.spectral_lines().size() == 2);
  CHECK(lamp.spectral_lines()[0].power == Approx(2.0 * lamp.spectral_lines()[1].power));
  CHECK(to_xyz(lamp).y == Approx(1.0).epsilon(1e-12));
  const Chromaticity c = chromaticity(to_xyz(lamp));
  CHECK(c.x == Approx(0.569).margin(2e-3)); // the spectral locus at 589 nm
  CHECK(c.y == Approx(0.430).margin(2e-3));
}

TEST_CASE("Lines are scaled, multiplied and compared as lines") {
  const Curve lines = Curve::lines({{500.0, 2.0}, {600.0, 3.0}});
  CHECK(lines.scaled(2.0) == Curve::lines({{500.0, 4.0}, {600.0, 6.0}}));
  const Curve ramp = Curve::table({400.0, 800.0}, {0.0, 1.0});
  CHECK(lines.times(ramp) == Curve::lines({{500.0, 0.5}, {600.0, 1.5}}));
  CHECK(ramp.times(lines) == lines.times(ramp));
  CHECK(lines.times(Curve::constant(0.5)) == lines.scaled(0.5));
  CHECK(lines.at(500.4) == 2.0);
  CHECK(lines.at(501.0) == 0.0);
  CHECK_FALSE(lines.constant_value().has_value());
  CHECK(ramp.spectral_lines().empty());
}

TEST_CASE("Lines that make no sense are refused") {
  CHECK_THROWS_AS(Curve::lines({}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::lines({{std::nan(""), 1.0}}), std::invalid_argument);
  CHECK_THROWS_AS(line_lamp(379.0), std::invalid_argument);
  CHECK_THROWS_AS(line_lamp(781.0), std::invalid_argument);
}

TEST_CASE("A wavelength finds its band") {
  const BandGrid grid(81);
  CHECK(grid.band_of(380.0) == 0);
  CHECK(grid.band_of(382.4) == 0);
  CHECK(grid.band_of(382.5) == 1);
  CHECK(grid.band_of(780.0) == 80);
  CHECK(grid.band_of(300.0) == 0);
  CHECK(grid.band_of(900.0) == 80);
}
