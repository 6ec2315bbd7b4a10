#include "spectral/band_colors.h"

#include "spectral/illuminant.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

/// The colour of a light that is known at some wavelengths.
Xyz color(const Curve& light, const std::vector<double>& nm,
          Observer observer = Observer::cie1931_2deg) {
  const std::vector<Xyz> bands = colors_of_bands(nm, observer);
  Xyz sum;
  for (std::size_t i = 0; i < nm.size(); ++i)
    sum += bands[i] * light.at(nm[i]);
  return sum;
}

std::vector<double> every(double step, double first, double last) {
  std::vector<double> nm;
  for (double at = first; at <= last; at += step)
    nm.push_back(at);
  return nm;
}

} // namespace

TEST_CASE("a spectrum of 1 is equal energy with Y = 1, at any wavelengths that cover the visible") {
  for (const double step : {1.0, 2.5, 5.0, 10.0, 20.0}) {
    INFO(step);
    const Xyz white = color(Curve::constant(1.0), every(step, 360.0, 830.0));
    CHECK(white.y == Approx(1.0).margin(1e-9));
    CHECK(chromaticity(white).x == Approx(1.0 / 3.0).margin(1e-4));
    CHECK(chromaticity(white).y == Approx(1.0 / 3.0).margin(1e-4));
  }
}

TEST_CASE("D65 at 5 and 10 nm has its published white") {
  const Curve d65 = *find_illuminant("D65");
  for (const auto& nm :
       {every(5.0, 380.0, 780.0), every(5.0, 360.0, 830.0), every(10.0, 380.0, 780.0)}) {
    const Xyz white = color(d65, nm);
    CHECK(chromaticity(white).x == Approx(0.3127).margin(1e-4));
    CHECK(chromaticity(white).y == Approx(0.3290).margin(1e-4));
  }
  const Xyz large = color(d65, every(5.0, 380.0, 780.0), Observer::cie1964_10deg);
  CHECK(chromaticity(large).x == Approx(0.3138).margin(1e-4)); // [CIE15]
  CHECK(chromaticity(large).y == Approx(0.3310).margin(1e-4));
}

TEST_CASE("the centres of a grid have the weights of its bands") {
  const BandGrid grid(9);
  std::vector<double> nm;
  for (int band = 0; band < 9; ++band)
    nm.push_back(grid.center_nm(band));
  CHECK(colors_of_bands(nm, Observer::cie1931_2deg) ==
        band_weights(grid, Curve::constant(1.0), Observer::cie1931_2deg));
}

TEST_CASE("a band of one wavelength is 5 nm wide") {
  // At 555 nm ybar is 1 and changes little; its sum over all nm is 106.86. [CIE018]
  const std::vector<double> one{555.0};
  const std::vector<Xyz> bands = colors_of_bands(one, Observer::cie1931_2deg);
  REQUIRE(bands.size() == 1);
  CHECK(bands[0].y == Approx(5.0 / 106.86).epsilon(2e-3));
}
