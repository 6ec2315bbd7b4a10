#include "spectral/metal.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("Metals are met at measured points") {
  // Johnson & Christy 1972, silver at 3.50 eV (354.2 nm); Rakic 1995, aluminium at 413.28 nm.
  const Metal* silver = find_metal("ag");
  REQUIRE(silver != nullptr);
  CHECK(silver->n.at(354.2) == 0.10);
  CHECK(silver->k.at(354.2) == 1.419);
  CHECK(find_metal("Al")->k.at(413.28) == 5.0008);
  CHECK(find_metal("Xx") == nullptr);
}

TEST_CASE("Metals reflect at normal incidence as they should look") {
  const auto reflectance = [](const char* symbol, double nm) {
    const Metal& metal = *find_metal(symbol);
    const double n = metal.n.at(nm);
    const double k = metal.k.at(nm);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  };
  // At 380 nm, interpolated linearly outside this project.
  CHECK(reflectance("Ag", 380.0) == Approx(0.953564).margin(1e-6));
  CHECK(reflectance("Au", 380.0) == Approx(0.402130).margin(1e-6));
  CHECK(reflectance("Al", 380.0) == Approx(0.924263).margin(1e-6));
  CHECK(reflectance("W", 380.0) == Approx(0.475339).margin(1e-6));
  CHECK(reflectance("Au", 700.0) > 2.0 * reflectance("Au", 450.0));
}

TEST_CASE("Ten metals cover all bands") {
  CHECK(metal_catalogue().size() == 10);
  for (const Metal& metal : metal_catalogue()) {
    INFO(metal.name);
    for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
      CHECK(metal.n.at(nm) > 0.0);
      CHECK(metal.k.at(nm) > 0.0);
    }
  }
}
