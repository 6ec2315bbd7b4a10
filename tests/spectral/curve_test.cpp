#include "spectral/curve.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace abbe;

namespace {

std::vector<double> ramp(double first, double step) {
  std::vector<double> values(81);
  for (int k = 0; k < 81; ++k)
    values[k] = first + step * k;
  return values;
}

} // namespace

TEST_CASE("A constant curve is the same everywhere and knows its value") {
  const Curve curve = Curve::constant(0.3);
  CHECK(curve.at(100.0) == 0.3);
  CHECK(curve.at(555.5) == 0.3);
  CHECK(curve.constant_value() == 0.3);
  CHECK(Curve().constant_value() == 0.0);
}

TEST_CASE("Samples are met exactly, linear between and held beyond") {
  std::vector<double> values(81);
  for (int k = 0; k < 81; ++k)
    values[k] = std::sin(0.1 * k);
  const Curve curve = Curve::samples81(values);
  for (int k = 0; k < 81; ++k)
    CHECK(curve.at(380.0 + 5.0 * k) == values[k]);
  CHECK(curve.at(382.5) == Approx((values[0] + values[1]) / 2));
  CHECK(curve.at(778.0) == Approx(0.4 * values[79] + 0.6 * values[80]));
  CHECK(curve.at(377.5) == values[0]);
  CHECK(curve.at(782.5) == values[80]);
  CHECK(curve.at(0.0) == values[0]);
  CHECK_FALSE(curve.constant_value().has_value());
}

TEST_CASE("A sampled curve has 81 finite values") {
  CHECK_THROWS_AS(Curve::samples81(std::vector<double>(80)), std::invalid_argument);
  CHECK_THROWS_AS(Curve::samples81(std::vector<double>(84)), std::invalid_argument);
  std::vector<double> values(81);
  values[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Curve::samples81(values), std::invalid_argument);
}

TEST_CASE("A table is met exactly, linear between, and held or zero outside") {
  const Curve held = Curve::table({400.0, 500.0, 700.0}, {1.0, 3.0, 2.0});
  CHECK(held.at(400.0) == 1.0);
  CHECK(held.at(500.0) == 3.0);
  CHECK(held.at(700.0) == 2.0);
  CHECK(held.at(425.0) == 1.5);
  CHECK(held.at(600.0) == 2.5);
  CHECK(held.at(399.0) == 1.0);
  CHECK(held.at(701.0) == 2.0);
  const Curve cut = Curve::table({400.0, 700.0}, {1.0, 2.0}, Outside::zero);
  CHECK(cut.at(400.0) == 1.0);
  CHECK(cut.at(700.0) == 2.0);
  CHECK(cut.at(399.999) == 0.0);
  CHECK(cut.at(700.001) == 0.0);
  CHECK(Curve::table({500.0}, {7.0}).at(380.0) == 7.0);
}

TEST_CASE("A table refuses what is not a function of wavelength") {
  CHECK_THROWS_AS(Curve::table({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::table({400.0}, {1.0, 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::table({400.0, 400.0}, {1.0, 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::table({500.0, 400.0}, {1.0, 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::table({400.0}, {INFINITY}), std::invalid_argument);
  CHECK_THROWS_AS(Curve::table({NAN}, {1.0}), std::invalid_argument);
}

TEST_CASE("Scaling keeps the kind of a curve") {
  CHECK(Curve::constant(2.0).scaled(3.0).constant_value() == 6.0);
  CHECK(Curve::samples81(ramp(1, 1)).scaled(2.0) == Curve::samples81(ramp(2, 2)));
  CHECK(Curve::table({400, 500}, {1, 2}, Outside::zero).scaled(2.0) ==
        Curve::table({400, 500}, {2, 4}, Outside::zero));
}

TEST_CASE("A constant times a curve scales it, in either order") {
  const Curve samples = Curve::samples81(ramp(1, 1));
  CHECK(Curve::constant(2.0).times(samples) == samples.scaled(2.0));
  CHECK(samples.times(Curve::constant(2.0)) == samples.scaled(2.0));
  CHECK(Curve::constant(2.0).times(Curve::constant(4.0)) == Curve::constant(8.0));
}

TEST_CASE("Samples times samples multiplies sample by sample") {
  const Curve product = Curve::samples81(ramp(1, 1)).times(Curve::samples81(ramp(2, 2)));
  std::vector<double> expected(81);
  for (int k = 0; k < 81; ++k)
    expected[k] = 2.0 * (k + 1) * (k + 1);
  CHECK(product == Curve::samples81(expected));
}

TEST_CASE("A product with a table is exact at the points of both factors") {
  const Curve samples = Curve::samples81(ramp(1, 1));
  const Curve table = Curve::table({381.0, 503.0, 650.0}, {1.0, 5.0, 2.0});
  for (const Curve& product : {samples.times(table), table.times(samples)})
    for (const double nm : {100.0, 380.0, 381.0, 400.0, 503.0, 505.0, 650.0, 780.0, 900.0})
      CHECK(product.at(nm) == Approx(samples.at(nm) * table.at(nm)));
}

TEST_CASE("A product is zero where a factor is zero outside its table") {
  const Curve cut = Curve::table({500.0, 600.0}, {1.0, 2.0}, Outside::zero);
  const Curve held = Curve::table({400.0, 550.0}, {3.0, 4.0});
  const Curve product = cut.times(held);
  CHECK(product.at(499.0) == 0.0);
  CHECK(product.at(500.0) == Approx(held.at(500.0)));
  CHECK(product.at(600.0) == 8.0);
  CHECK(product.at(601.0) == 0.0);
  const Curve apart = Curve::table({700.0, 710.0}, {1.0, 1.0}, Outside::zero);
  CHECK(cut.times(apart) == Curve::constant(0.0));
}

TEST_CASE("The mean of a table is its integral over the width") {
  const Curve table = Curve::table({400.0, 410.0, 430.0}, {0.0, 1.0, 3.0});
  CHECK(table.mean(400.0, 410.0) == Approx(0.5));
  CHECK(table.mean(405.0, 420.0) ==
        Approx((0.5 * (0.5 + 1.0) * 5.0 + 0.5 * (1.0 + 2.0) * 10.0) / 15.0));
  CHECK(table.mean(390.0, 400.0) == 0.0); // held beyond its ends
  CHECK(table.mean(425.0, 435.0) == Approx(0.1 * (2.75 * 5.0 + 3.0 * 5.0)));
  const Curve cut = Curve::table({400.0, 410.0}, {2.0, 4.0}, Outside::zero);
  CHECK(cut.mean(395.0, 405.0) == Approx(0.1 * 2.5 * 5.0));
  CHECK(cut.mean(420.0, 430.0) == 0.0);
  // A sample stands for its cell, whose mean it is.
  std::vector<double> samples(81, 1.0);
  samples[4] = 5.0;
  const Curve sampled = Curve::samples81(samples);
  CHECK(sampled.mean(397.5, 402.5) == 5.0);
  CHECK(sampled.sampled81() == sampled);
  CHECK(table.sampled81().at(405.0) == Approx(0.5));
}
