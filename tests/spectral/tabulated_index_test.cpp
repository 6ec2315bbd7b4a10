#include "spectral/dispersion.h"
#include "spectral/glass.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

TEST_CASE("A table of n is met at its points and held beyond them") {
  const TabulatedIndex law = tabulated_index({400.0, 500.0, 650.0}, {1.53, 1.52, 1.515});
  CHECK(refractive_index(law, 400.0) == 1.53);
  CHECK(refractive_index(law, 500.0) == Approx(1.52).epsilon(1e-15));
  CHECK(refractive_index(law, 650.0) == 1.515);
  CHECK(refractive_index(law, 380.0) == 1.53);
  CHECK(refractive_index(law, 780.0) == 1.515);
  CHECK_FALSE(is_achromatic(law));
}

TEST_CASE("A table never leaves the interval of two neighbours") {
  // A jump, at which a parabola through three points overshoots.
  const TabulatedIndex law =
      tabulated_index({400.0, 450.0, 455.0, 500.0, 600.0}, {1.60, 1.599, 1.50, 1.499, 1.499});
  double before = 1.60;
  for (double nm = 400.0; nm <= 600.0; nm += 0.5) {
    const double n = refractive_index(law, nm);
    CHECK(n <= before + 1e-15);
    CHECK(n >= 1.499 - 1e-15);
    before = n;
  }
}

TEST_CASE("A line stays a line; one point and equal points are achromatic") {
  const TabulatedIndex line = tabulated_index({400.0, 500.0, 700.0}, {1.6, 1.55, 1.45});
  for (double nm = 400.0; nm <= 700.0; nm += 25.0)
    CHECK(refractive_index(line, nm) == Approx(1.6 - 0.0005 * (nm - 400.0)).epsilon(1e-14));
  CHECK(refractive_index(tabulated_index({400.0, 700.0}, {1.6, 1.45}), 500.0) ==
        Approx(1.55).epsilon(1e-14));
  CHECK(is_achromatic(tabulated_index({550.0}, {1.5})));
  CHECK(refractive_index(tabulated_index({550.0}, {1.5}), 400.0) == 1.5);
  CHECK(is_achromatic(tabulated_index({400.0, 700.0}, {1.5, 1.5})));
}

TEST_CASE("A glass tabulated every 25 nm comes back to 2e-4") {
  const Dispersion& glass = find_glass("N-SF11")->dispersion;
  std::vector<double> nm, n;
  for (double at = 375.0; at <= 800.0; at += 25.0) {
    nm.push_back(at);
    n.push_back(refractive_index(glass, at));
  }
  const TabulatedIndex law = tabulated_index(nm, n);
  for (double at = 380.0; at <= 780.0; at += 1.0)
    CHECK(refractive_index(law, at) == Approx(refractive_index(glass, at)).margin(2e-4));
}

TEST_CASE("Tables of n that make no sense are refused") {
  CHECK_THROWS_AS(tabulated_index({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_index({400.0}, {1.5, 1.6}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_index({500.0, 400.0}, {1.5, 1.6}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_index({400.0, 500.0}, {1.5, std::nan("")}), std::invalid_argument);
}
