#include "spectral/color_space.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

#include <algorithm>

using namespace abbe;

TEST_CASE("The matrix of every colour space is the expected one") {
  const test::Expected expected("colourspace_matrices.csv");
  int compared = 0;
  for (int row = 0; row < expected.row_count(); ++row) {
    const auto space = find_color_space(expected.text(row, "name"));
    INFO(expected.text(row, "name"));
    REQUIRE(space.has_value());
    const Matrix3 to_xyz = rgb_to_xyz_matrix(space->primaries, space->white);
    const Matrix3 to_rgb = inverse(to_xyz);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const std::string cell = std::to_string(i) + std::to_string(j);
        CHECK(to_xyz[i][j] == Approx(expected.number(row, "m" + cell)).margin(2e-9));
        CHECK(to_rgb[i][j] == Approx(expected.number(row, "i" + cell)).margin(2e-9));
      }
    ++compared;
  }
  CHECK(compared >= 13);
}

TEST_CASE("sRGB in the table is the sRGB of the code") {
  const auto space = find_color_space("srgb / rec.709");
  REQUIRE(space.has_value());
  CHECK(space->primaries == kSrgbPrimaries);
  CHECK(space->white == kSrgbWhite);
  CHECK_FALSE(find_color_space("no such space").has_value());
}

TEST_CASE("Every space has a short name of its own and a transfer function") {
  const auto names = color_space_names();
  for (const std::string& name : names) {
    INFO(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
    REQUIRE(find_color_space(name).has_value());
  }
  for (const ColorSpace& space : color_spaces())
    CHECK_FALSE(space.short_names.empty());
  CHECK(find_color_space("Display-P3")->name == "Display P3");
  CHECK(find_color_space("p22")->name == "SMPTE-C");
  CHECK(srgb_space().transfer == srgb_transfer());
  CHECK(find_color_space("ntsc")->transfer.exponent == 2.2);
  CHECK(find_color_space("acescg")->transfer == linear_transfer());
}

TEST_CASE(
    "The thesis's T = C L gives white for equal primaries and each primary its chromaticity") {
  for (const ColorSpace& space : color_spaces()) {
    INFO(space.name);
    const Matrix3 m = rgb_to_xyz_matrix(space.primaries, space.white);
    const auto seen = [&](const Vector3& rgb) {
      const Vector3 xyz = multiply(m, rgb);
      return chromaticity({xyz[0], xyz[1], xyz[2]});
    };
    const auto same = [](const Chromaticity& a, const Chromaticity& b) {
      CHECK(a.x == Approx(b.x).margin(1e-13));
      CHECK(a.y == Approx(b.y).margin(1e-13));
    };
    same(seen({1, 1, 1}), space.white);
    same(seen({1, 0, 0}), space.primaries.red);
    same(seen({0, 1, 0}), space.primaries.green);
    same(seen({0, 0, 1}), space.primaries.blue);
    CHECK(m[1][0] + m[1][1] + m[1][2] == Approx(1.0).epsilon(1e-13));
  }
}
