#include "core/film/strata.h"
#include "tests/catch.h"

#include <vector>

using namespace abbe;

// The strata of n samples: the first power-of-two many of them, as many as leave something.
TEST_CASE("the boundary is the largest power of two below the number of samples") {
  const std::vector<std::uint32_t> of_number{0, 1, 2, 2, 4, 4, 4, 4, 8};
  for (std::uint32_t n = 1; n <= of_number.size(); ++n)
    CHECK(strata_boundary(n - 1) == of_number[n - 1]);
}

// What lies beyond a boundary lies below the next, so that a stratum can be closed as a whole.
TEST_CASE("samples of the second stratum all belong to the first of a higher boundary") {
  for (std::uint32_t last = 0; last < 300; ++last) {
    const PixelStrata before{strata_boundary(last), 0};
    CHECK(before.of(last) == Stratum::second);
    for (std::uint32_t later = last; later < 300; ++later) {
      const PixelStrata after{strata_boundary(later), 0};
      if (after.boundary > before.boundary) REQUIRE(after.of(last) == Stratum::first);
    }
  }
}
