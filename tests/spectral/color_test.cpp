#include "spectral/color.h"
#include "tests/catch.h"

#include <stdexcept>

using namespace abbe;

TEST_CASE("The sRGB white is RGB 1 1 1 with Y = 1") {
  const Xyz white = to_xyz(LinearRgb{1, 1, 1});
  CHECK(white.y == Approx(1.0).epsilon(1e-15));
  CHECK(chromaticity(white).x == Approx(0.3127).epsilon(1e-14));
  CHECK(chromaticity(white).y == Approx(0.3290).epsilon(1e-14));
}

TEST_CASE("The luminance of the Rec. 709 primaries is the published one") {
  // ITU-R BT.709-6 rounds to four decimals.
  CHECK(luminance({1, 0, 0}) == Approx(0.2126).margin(5e-5));
  CHECK(luminance({0, 1, 0}) == Approx(0.7152).margin(5e-5));
  CHECK(luminance({0, 0, 1}) == Approx(0.0722).margin(5e-5));
}

TEST_CASE("XYZ to linear sRGB and back changes nothing") {
  const Xyz color{0.3, 0.9, -0.1};
  const Xyz back = to_xyz(to_linear_srgb(color));
  CHECK(back.x == Approx(color.x).epsilon(1e-14));
  CHECK(back.y == Approx(color.y).epsilon(1e-14));
  CHECK(back.z == Approx(color.z).epsilon(1e-14));
}

TEST_CASE("The sRGB curve has the values of its standard") {
  // Closed form: 1.055 * 0.5^(1/2.4) - 0.055, and 12.92 * 0.002 on the straight part.
  const DisplayRgb code = encode_srgb({0.5, 0.002, 1.0});
  CHECK(code.r == Approx(0.7353569830524495).epsilon(1e-14));
  CHECK(code.g == Approx(0.02584).epsilon(1e-14));
  CHECK(code.b == Approx(1.0).epsilon(1e-15));
  CHECK(encode_srgb({0, 0, 0}) == DisplayRgb{0, 0, 0});
}

TEST_CASE("Decoding undoes encoding, below zero and above one too") {
  for (double v = -1.5; v < 2.0; v += 0.013) {
    const LinearRgb back = decode_srgb(encode_srgb({v, -v, 0.01 * v}));
    CHECK(back.r == Approx(v).epsilon(1e-13).margin(1e-9));
    CHECK(back.g == -back.r);
    CHECK(back.b == Approx(0.01 * v).epsilon(1e-13).margin(1e-9));
  }
}

TEST_CASE("Chromaticity is the share of the sum") {
  CHECK(chromaticity({1, 2, 5}) == Chromaticity{0.125, 0.25});
  CHECK(chromaticity({0, 0, 0}) == Chromaticity{1.0 / 3.0, 1.0 / 3.0});
  const Xyz color = to_xyz(Chromaticity{0.25, 0.5}, 3.0);
  CHECK(color == Xyz{1.5, 3.0, 1.5});
}

TEST_CASE("XYZ adds and scales by component") {
  CHECK(Xyz{1, 2, 3} + Xyz{10, 20, 30} * 2.0 == Xyz{21, 42, 63});
  CHECK(2.0 * Xyz{1, 2, 3} == Xyz{2, 4, 6});
}

TEST_CASE("Primaries on one line make no colour space") {
  CHECK_THROWS_AS(rgb_to_xyz_matrix({{0, 0}, {0.25, 0.25}, {0.5, 0.5}}, kSrgbWhite),
                  std::invalid_argument);
  CHECK_THROWS_AS(rgb_to_xyz_matrix(kSrgbPrimaries, {0.3, 0.0}), std::invalid_argument);
}
