#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

#include <algorithm>

using namespace abbe;

TEST_CASE("Every illuminant has the white point of its table and of the standard") {
  const test::Expected whites("whites.csv");
  const auto names = illuminant_names();
  int known = 0;
  for (int row = 0; row < whites.row_count(); ++row) {
    const std::string name = whites.text(row, "name");
    INFO(name);
    const auto light = find_illuminant(name);
    REQUIRE(light.has_value());
    CHECK(std::count(names.begin(), names.end(), name) == 1);
    const Xyz white = to_xyz(*light);
    CHECK(white.y == Approx(1.0).epsilon(1e-14));
    CHECK(white.x == Approx(whites.number(row, "X_5nm")).margin(1e-8));
    CHECK(white.z == Approx(whites.number(row, "Z_5nm")).margin(1e-8));
    CHECK(chromaticity(white).x == Approx(whites.number(row, "x_pub")).margin(5.1e-5));
    CHECK(chromaticity(white).y == Approx(whites.number(row, "y_pub")).margin(5.1e-5));
    const Chromaticity large = chromaticity(to_xyz(*light, Observer::cie1964_10deg));
    CHECK(large.x == Approx(whites.number(row, "x10_pub")).margin(4e-4));
    CHECK(large.y == Approx(whites.number(row, "y10_pub")).margin(4e-4));
    ++known;
  }
  CHECK(known == 30);
}

TEST_CASE("D65 is 0.95043 1 1.08880") {
  const Xyz white = to_xyz(*find_illuminant("D65"));
  CHECK(white.x == Approx(0.95043).margin(5e-6));
  CHECK(white.z == Approx(1.08880).margin(5e-6));
}

TEST_CASE("E is the constant 1") {
  CHECK(find_illuminant("E")->constant_value() == 1.0);
}

TEST_CASE("Names of illuminants ignore case, unknown ones give nothing") {
  CHECK(find_illuminant("led-rgb1") == find_illuminant("LED-RGB1"));
  CHECK(find_illuminant("d65").has_value());
  CHECK_FALSE(find_illuminant("D66").has_value());
  CHECK_FALSE(find_illuminant("").has_value());
  const auto names = illuminant_names();
  CHECK(names.size() == 32);
  CHECK(std::is_sorted(names.begin(), names.end()));
}

TEST_CASE("A lamp's samples keep the ratios of its table") {
  // CIE 15 table T.1: D65 is 49.9755 at 380 nm and 63.3828 at 780 nm.
  const Curve light = *find_illuminant("D65");
  CHECK(light.at(380.0) / light.at(780.0) == Approx(49.9755 / 63.3828).epsilon(1e-14));
}
