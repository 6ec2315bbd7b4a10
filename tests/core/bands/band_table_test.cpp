#include "core/bands/band_table.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("band arrays are padded to whole registers") {
  CHECK(padded_band_count(1) == 16);
  CHECK(padded_band_count(16) == 16);
  CHECK(padded_band_count(17) == 32);
  CHECK(padded_band_count(81) == 96);
}

TEST_CASE("a constant table knows its value, and whether it is 0") {
  const BandTable half(0.5f, 3), none(0.0f, 3);
  CHECK(half.constant() == 0.5f);
  CHECK_FALSE(half.zero());
  CHECK(half[2] == 0.5f);
  CHECK(none.zero());
  CHECK(none.constant() == 0.0f);
  CHECK(BandTable().zero());
}

TEST_CASE("a table of values has them, zeros behind, and no constant") {
  const BandTable table(std::vector<double>{1.0, 0.5, 0.25});
  CHECK_FALSE(table.constant());
  CHECK_FALSE(table.zero());
  CHECK(table[1] == 0.5f);
  for (int b = 3; b < 16; ++b)
    CHECK(table[b] == 0.0f);
  CHECK(BandTable(std::vector<double>{0.0, 0.0}).zero());
}

TEST_CASE("a curve is evaluated at the bands' centres") {
  const BandGrid grid(81);
  const Curve ramp = Curve::table({380.0, 780.0}, {0.0, 1.0});
  const BandTable table = BandTable::at_centers(grid, ramp, true);
  CHECK_FALSE(table.constant());
  for (int b = 0; b < 81; ++b)
    CHECK(table[b] == Approx(b / 80.0).margin(1e-7));
}

TEST_CASE("a constant curve is stored as one number only when that is asked for") {
  const BandGrid grid(27);
  const Curve flat = Curve::constant(0.3);
  const BandTable kept = BandTable::at_centers(grid, flat, true);
  const BandTable spread = BandTable::at_centers(grid, flat, false);
  CHECK(kept.constant() == 0.3f);
  CHECK_FALSE(spread.constant());
  for (int b = 0; b < 27; ++b)
    CHECK(kept[b] == spread[b]);
  CHECK(BandTable::at_centers(grid, Curve(), true).zero());
  CHECK(BandTable::at_centers(grid, Curve(), false).zero());
}

TEST_CASE("a number is added in the bands and not in the padding") {
  const BandTable sum = BandTable(std::vector<double>{0.0, 0.5}).plus(0.25f, 2);
  CHECK(sum[0] == 0.25f);
  CHECK(sum[1] == 0.75f);
  CHECK(sum[2] == 0.0f);
  CHECK_FALSE(sum.zero());
  CHECK(BandTable(0.5f, 2).plus(0.25f, 2).constant() == 0.75f);
}
