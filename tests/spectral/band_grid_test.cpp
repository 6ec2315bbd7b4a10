#include "spectral/band_grid.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("81 bands are centred on the thesis's samples, exactly") {
  const BandGrid grid(81);
  CHECK(grid.width_nm() == 5.0);
  for (int k = 0; k < 81; ++k) {
    CHECK(grid.center_nm(k) == 380.0 + 5.0 * k);
    CHECK(grid.center_nm(k) == sample_nm(k));
    CHECK(grid.lower_nm(k) == 377.5 + 5.0 * k);
  }
}

TEST_CASE("405 bands are centred on whole nanometres") {
  const BandGrid grid(405);
  CHECK(grid.center_nm(0) == 378.0);
  CHECK(grid.center_nm(404) == 782.0);
}

TEST_CASE("Bands of any number cover the range without gap or overlap") {
  for (const int count : {1, 3, 9, 10, 27, 81, 100, 405}) {
    const BandGrid grid(count);
    CHECK(grid.count() == count);
    CHECK(grid.lower_nm(0) == kLowerNm);
    CHECK(grid.lower_nm(count) == kUpperNm);
    for (int band = 0; band < count; ++band) {
      CHECK(grid.wavelength_nm(band, 0.0) == grid.lower_nm(band));
      CHECK(grid.wavelength_nm(band, 1.0) == grid.lower_nm(band + 1));
      CHECK(grid.wavelength_nm(band, 0.25) ==
            Approx(grid.lower_nm(band) + grid.width_nm() / 4).margin(1e-10));
    }
  }
}

TEST_CASE("A grid refuses other numbers of bands") {
  for (const int count : {-1, 0, 406})
    CHECK_THROWS_AS(BandGrid(count), std::invalid_argument);
}

TEST_CASE("Grids are equal when their counts are") {
  CHECK(BandGrid(27) == BandGrid(27));
  CHECK_FALSE(BandGrid(27) == BandGrid(81));
}
