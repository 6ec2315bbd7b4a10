#include "spectral/color_space.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

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
