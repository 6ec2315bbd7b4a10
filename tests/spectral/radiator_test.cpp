#include "spectral/band_grid.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "spectral/radiator.h"
#include "tests/catch.h"

#include <cmath>
#include <stdexcept>

using namespace abbe;

TEST_CASE("A blackbody has Y = 1 and Planck's ratios") {
  // c2 = hc/k = 1.438776877e-2 m K (CODATA 2018).
  const auto planck = [](double nm, double kelvin) {
    return std::pow(nm, -5.0) / std::expm1(1.438776877e7 / (nm * kelvin));
  };
  for (const double kelvin : {1000.0, 2856.0, 6504.0, 1e5}) {
    const Curve light = blackbody(kelvin);
    CHECK(to_xyz(light).y == Approx(1.0).epsilon(1e-14));
    for (const double nm : {380.0, 450.0, 780.0})
      CHECK(light.at(nm) / light.at(555.0) ==
            Approx(planck(nm, kelvin) / planck(555.0, kelvin)).epsilon(1e-8));
  }
}

TEST_CASE("Illuminant A is a blackbody near 2856 K") {
  // CIE 15 defines A as Planck's law with c2 = 1.435e-2 m K at 2848 K: the same ratio c2/T as
  // 2848 * 1.438776877 / 1.435 K with today's constant. Its table has six digits.
  const Curve planck = blackbody(2848.0 * 1.438776877 / 1.435);
  const Curve table = *find_illuminant("A");
  for (int k = 0; k < 81; ++k)
    CHECK(planck.at(sample_nm(k)) == Approx(table.at(sample_nm(k))).epsilon(1e-5));
}

TEST_CASE("Extreme temperatures stay finite") {
  for (const double kelvin : {1.0, 50.0, 1e9, 1e300}) {
    const Xyz xyz = to_xyz(blackbody(kelvin));
    CHECK(std::isfinite(xyz.x));
    CHECK(xyz.y == Approx(1.0));
  }
}

TEST_CASE("A blackbody needs a temperature") {
  for (const double kelvin : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    CHECK_THROWS_AS(blackbody(kelvin), std::invalid_argument);
}

TEST_CASE("Daylight at its nominal temperatures is the tabulated D50, D55, D65, D75") {
  // The nominal temperature was set with c2 = 1.4380e-2 m K [CIE15]. Tables are rounded, to 1e-3 of
  // a value near 100 at worst, and before 2004 were computed with unrounded M1 and M2.
  const std::pair<const char*, double> cases[] = {
      {"D50", 5000.0}, {"D55", 5500.0}, {"D65", 6500.0}, {"D75", 7500.0}};
  for (const auto& [name, nominal] : cases) {
    const Curve computed = cie_daylight(nominal * 1.4388 / 1.4380);
    const Curve table = *find_illuminant(name);
    INFO(name);
    for (int k = 0; k < 81; ++k)
      CHECK(computed.at(sample_nm(k)) == Approx(table.at(sample_nm(k))).epsilon(2e-4));
  }
}

TEST_CASE("Daylight is continuous where its formula changes, and ends where the CIE ends it") {
  const Chromaticity below = chromaticity(to_xyz(cie_daylight(7000.0)));
  const Chromaticity above = chromaticity(to_xyz(cie_daylight(7000.1)));
  CHECK(below.x == Approx(above.x).margin(2e-4));
  CHECK(below.y == Approx(above.y).margin(2e-4));
  CHECK_NOTHROW(cie_daylight(4000.0));
  CHECK_NOTHROW(cie_daylight(25000.0));
  for (const double kelvin : {3999.0, 25001.0, static_cast<double>(NAN)})
    CHECK_THROWS_AS(cie_daylight(kelvin), std::invalid_argument);
}
