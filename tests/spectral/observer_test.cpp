#include "spectral/color_difference.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

#include <numeric>

using namespace abbe;

namespace {

Xyz sum(const std::vector<Xyz>& weights) {
  return std::accumulate(weights.begin(), weights.end(), Xyz{});
}

Curve column_of_81(const test::Expected& table, const std::string& column) {
  std::vector<double> values = table.numbers(column);
  values.resize(81);
  return Curve::samples81(values);
}

} // namespace

TEST_CASE("Equal energy has Y = 1 for every number of bands and both observers") {
  for (const Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
    for (int count = 1; count <= 405; ++count) {
      const auto weights = band_weights(BandGrid(count), Curve::constant(1.0), observer);
      REQUIRE(weights.size() == static_cast<std::size_t>(count));
      INFO(count);
      CHECK(sum(weights).y == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("A white does not change with the number of bands up to 81") {
  for (const char* name : {"D65", "A", "FL11", "HP1", "LED-RGB1"}) {
    const Curve light = *find_illuminant(name);
    const Xyz white = to_xyz(light);
    for (const int count : {1, 2, 3, 9, 10, 27, 40, 80, 81}) {
      INFO(name << ' ' << count);
      const Xyz folded = sum(band_weights(BandGrid(count), light));
      CHECK(folded.x == Approx(white.x).epsilon(1e-13));
      CHECK(folded.y == Approx(white.y).epsilon(1e-13));
      CHECK(folded.z == Approx(white.z).epsilon(1e-13));
    }
  }
}

TEST_CASE("Above 81 bands a white is that of the 1 nm table") {
  const Curve light = *find_illuminant("D65");
  const Xyz white = sum(band_weights(BandGrid(405), light));
  CHECK(white.y == Approx(1.0).epsilon(3e-4));
  // whites.csv, the 1 nm column over 360-830 nm. Our range leaves out 360-377 nm, where zbar sums
  // to about 0.03 of 107 under half of D65's mean power: 1.4e-4 of Z, and a third of that in x + y.
  CHECK(chromaticity(white).x == Approx(0.3127263).margin(5e-5));
  CHECK(chromaticity(white).y == Approx(0.3290233).margin(5e-5));
  const Xyz coarser = sum(band_weights(BandGrid(100), light));
  CHECK(coarser.x == Approx(white.x).epsilon(1e-13));
  CHECK(coarser.y == Approx(white.y).epsilon(1e-13));
  CHECK(coarser.z == Approx(white.z).epsilon(1e-13));
}

TEST_CASE("Groups of samples fold exactly, and a part of a cell in proportion") {
  const Curve light = *find_illuminant("D65");
  const auto fine = band_weights(BandGrid(81), light);
  const auto groups = band_weights(BandGrid(27), light);
  for (int g = 0; g < 27; ++g) {
    const Xyz folded = fine[3 * g] + fine[3 * g + 1] + fine[3 * g + 2];
    CHECK(groups[g].x == Approx(folded.x).epsilon(1e-13));
    CHECK(groups[g].z == Approx(folded.z).epsilon(1e-13).margin(1e-18));
  }
  // Two bands meet in the middle of cell 40.
  Xyz half = 0.5 * fine[40];
  for (int k = 0; k < 40; ++k)
    half += fine[k];
  CHECK(band_weights(BandGrid(2), light)[0].y == Approx(half.y).epsilon(1e-13));
}

TEST_CASE("81 weights are the standard's 5 nm values over the sum of ybar") {
  // First and last row of the CIE 1931 table: 380 nm 0.001368, 780 nm ybar 0.00001499.
  const auto weights = band_weights(BandGrid(81), Curve::constant(1.0));
  CHECK(weights[0].x / weights[80].y == Approx(0.001368 / 0.00001499).epsilon(1e-12));
  // The sum of ybar at 5 nm is 21.3714 [CIE15]: 106.857 nm over 5 nm.
  CHECK(0.00001499 / weights[80].y == Approx(21.3714).margin(1e-3));
}

TEST_CASE("Band means are the means of the samples in a band") {
  std::vector<double> values(81);
  std::iota(values.begin(), values.end(), 0.0);
  const Curve ramp = Curve::samples81(values);
  const auto fine = band_means(BandGrid(81), ramp);
  const auto groups = band_means(BandGrid(9), ramp);
  for (int k = 0; k < 81; ++k)
    CHECK(fine[k] == Approx(values[k]).margin(1e-14));
  for (int g = 0; g < 9; ++g)
    CHECK(groups[g] == Approx(9.0 * g + 4.0));
  // Half of 81 samples: 40 whole cells and half of cell 40.
  CHECK(band_means(BandGrid(2), ramp)[0] == Approx((780.0 + 0.5 * 40.0) / 40.5));
  CHECK(band_means(BandGrid(405), ramp)[202] == Approx(40.0));
  for (const int count : {1, 10, 81, 100, 405})
    for (const double mean : band_means(BandGrid(count), Curve::constant(0.3)))
      CHECK(mean == Approx(0.3).epsilon(1e-14));
}

TEST_CASE("The thesis's spectra have the expected XYZ") {
  const test::Expected spectra("appendix_a.csv");
  const test::Expected expected("golden_seed_spectra.csv");
  const Curve filter = column_of_81(spectra, "filter_2a");
  // The surface's list ends at the 81st value; its fields after that are empty.
  std::vector<double> values;
  for (int row = 0; row < 81; ++row)
    values.push_back(spectra.number(row, "strong_orange_yellow"));
  const Curve surface = Curve::samples81(values);
  const auto check = [&](int row, const Curve& light) {
    const Xyz xyz = to_xyz(light);
    INFO(expected.text(row, "what"));
    CHECK(xyz.x == Approx(expected.number(row, "X")).margin(1e-9));
    CHECK(xyz.y == Approx(expected.number(row, "Y")).margin(1e-9));
    CHECK(xyz.z == Approx(expected.number(row, "Z")).margin(1e-9));
    const LinearRgb rgb = to_linear_srgb(xyz);
    CHECK(rgb.r == Approx(expected.number(row, "R")).margin(1e-7));
    CHECK(rgb.g == Approx(expected.number(row, "G")).margin(1e-7));
    CHECK(rgb.b == Approx(expected.number(row, "B")).margin(1e-7));
  };
  check(0, filter);
  check(2, surface);
  check(3, filter.times(surface));
  check(4, Curve::constant(1.0));
  check(5, filter.scaled(0.85));
}

TEST_CASE("The ColorChecker has the expected XYZ, RGB and Lab at 81 bands") {
  const test::Expected patches("colorchecker_ohta.csv");
  const test::Expected expected("golden_colorchecker.csv");
  CHECK(expected.row_count() == 50);
  for (int row = 0; row < expected.row_count(); ++row) {
    const Curve light = *find_illuminant(expected.text(row, "illuminant"));
    const std::string number = expected.text(row, "patch");
    const Curve reflectance =
        number == "0" ? Curve::constant(1.0) // the row "perfect white"
                      : column_of_81(patches, (number.size() == 1 ? "p0" : "p") + number);
    const Xyz xyz = to_xyz(light.times(reflectance));
    const LinearRgb rgb = to_linear_srgb(xyz);
    const Lab lab = to_lab(xyz, to_xyz(light));
    INFO(expected.text(row, "illuminant") << ' ' << expected.text(row, "name"));
    CHECK(xyz.x == Approx(expected.number(row, "X")).margin(1e-8));
    CHECK(xyz.y == Approx(expected.number(row, "Y")).margin(1e-8));
    CHECK(xyz.z == Approx(expected.number(row, "Z")).margin(1e-8));
    CHECK(rgb.r == Approx(expected.number(row, "R")).margin(1e-7));
    CHECK(rgb.g == Approx(expected.number(row, "G")).margin(1e-7));
    CHECK(rgb.b == Approx(expected.number(row, "B")).margin(1e-7));
    CHECK(lab.l == Approx(expected.number(row, "L")).margin(1e-6));
    CHECK(lab.a == Approx(expected.number(row, "a")).margin(1e-6));
    CHECK(lab.b == Approx(expected.number(row, "b")).margin(1e-6));
  }
}
