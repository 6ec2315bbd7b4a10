#include "spectral/dispersion.h"
#include "spectral/glass.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>

using namespace abbe;

TEST_CASE("Cauchy's formula by hand") {
  // L = 1/2 um: 1.5 + 0.004 * 4 + 0.0001 * 16.
  const Cauchy law{1.5, 0.004, 0.0001};
  CHECK(refractive_index(law, 500.0) == Approx(1.5176).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(Cauchy{1.5, 0.0, 0.0}));
}

TEST_CASE("The Cauchy law of an Abbe number meets n_d and V_d of every data sheet") {
  int compared = 0;
  for (const Glass& glass : glass_catalogue()) {
    if (!glass.published_source.starts_with("vendor data sheet")) continue;
    INFO(glass.name);
    const Dispersion law = cauchy_of_abbe(*glass.n_d, *glass.v_d);
    CHECK(refractive_index(law, kLineD_nm) == Approx(*glass.n_d).epsilon(1e-14));
    CHECK(abbe_number(law) == Approx(*glass.v_d).epsilon(1e-11));
    ++compared;
  }
  CHECK(compared == 72);
}

TEST_CASE("Between the lines the law of an Abbe number is near the glass") {
  for (const char* name : {"N-BK7", "N-SF11", "N-F2"}) {
    const Glass& glass = *find_glass(name);
    INFO(name);
    const Cauchy law = cauchy_of_abbe(*glass.n_d, *glass.v_d);
    double worst = 0.0;
    for (double nm = 430.0; nm <= 700.0; nm += 10.0)
      worst = std::max(
          worst, std::abs(refractive_index(law, nm) - refractive_index(glass.dispersion, nm)));
    CHECK(worst < 4e-3);
    CHECK(worst > 1e-5); // two numbers are not a glass
  }
}
