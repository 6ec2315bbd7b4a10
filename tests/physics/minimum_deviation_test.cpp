#include "io/selftest/expected_index.h"
#include "io/selftest/prism_rows.h"
#include "tests/catch.h"

using namespace abbe;

// At minimum deviation the ray runs parallel to the base, so sin((A + delta) / 2) = n sin(A / 2):
// delta = 2 asin(n / 2) - 60 deg for A = 60 deg. The three figures are computed from Schott's
// Sellmeier coefficients, not by this program.
TEST_CASE("a 60 degree N-BK7 prism has its published minimum deviation at F, d and C") {
  const World world = prism_world();
  const auto at = [&](double nm) {
    return minimum_deviation_deg(world, catalogue_index("N-BK7", nm));
  };
  CHECK(at(486.1327) == Approx(39.1381).margin(1e-4));
  CHECK(at(587.5618) == Approx(38.6467).margin(1e-4));
  CHECK(at(656.2725) == Approx(38.4291).margin(1e-4));
}

TEST_CASE("red is bent least: deviation falls with wavelength over all bands") {
  const World world = prism_world();
  double last = 180.0;
  for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
    const double now = minimum_deviation_deg(world, catalogue_index("SF11", nm));
    CHECK(now < last);
    last = now;
  }
}
