#include "spectral/color_difference.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

using namespace abbe;

TEST_CASE("CIEDE2000 has the values of its test pairs, in both orders") {
  const test::Expected pairs("delta_e_2000.csv"); // [SWD05, table 1]
  REQUIRE(pairs.row_count() == 34);
  for (int row = 0; row < pairs.row_count(); ++row) {
    const auto value = [&](const char* column) { return pairs.number(row, column); };
    const Lab first{value("L1"), value("a1"), value("b1")};
    const Lab second{value("L2"), value("a2"), value("b2")};
    INFO(first.l << ' ' << first.a << ' ' << first.b);
    CHECK(delta_e_2000(first, second) == Approx(value("difference")).margin(5.1e-5));
    CHECK(delta_e_2000(second, first) == Approx(value("difference")).margin(5.1e-5));
  }
  CHECK(delta_e_2000({50, 10, -20}, {50, 10, -20}) == 0.0);
  CHECK(delta_e_2000({50, 0, 0}, {50, 0, 0}) == 0.0);
}

TEST_CASE("CIELAB of white, black and a dark grey") {
  const Xyz white{0.95, 1.0, 1.09};
  const Lab of_white = to_lab(white, white);
  CHECK(of_white.l == Approx(100.0));
  CHECK(of_white.a == Approx(0.0).margin(1e-12));
  CHECK(to_lab({0, 0, 0}, white).l == Approx(0.0).margin(1e-12));
  // On the straight part L* = (29/3)^3 Y; above it L* = 116 Y^(1/3) - 16.
  CHECK(to_lab(white * 0.004, white).l == Approx(24389.0 / 27.0 * 0.004));
  CHECK(to_lab(white * 0.125, white).l == Approx(42.0));
}
