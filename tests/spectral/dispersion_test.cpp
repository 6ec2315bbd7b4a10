#include "spectral/dispersion.h"
#include "tests/catch.h"

#include <cmath>
#include <limits>

using namespace abbe;

TEST_CASE("A constant index is constant and has no Abbe number") {
  const Dispersion law = ConstantIndex{1.33};
  CHECK(refractive_index(law, 400.0) == 1.33);
  CHECK(is_achromatic(law));
  CHECK(abbe_number(law) == std::numeric_limits<double>::infinity());
}

TEST_CASE("The thesis's quintic gives 1.4465 at 589 nm, in micrometres") {
  CHECK(refractive_index(ThesisPolynomial{}, 589.0) == Approx(1.4465).margin(5e-5));
  // At 1 um it is the sum of the printed coefficients.
  CHECK(refractive_index(ThesisPolynomial{}, 1000.0) ==
        Approx(1.816731 - 1.85629 + 3.514845 - 3.12787 + 1.310301 - 0.2085667).epsilon(1e-14));
  CHECK_FALSE(is_achromatic(Dispersion{ThesisPolynomial{}}));
}

TEST_CASE("The thesis's line starts at 1.56973 and loses 0.02204 over 405 nm") {
  CHECK(refractive_index(ThesisLinear{}, 380.0) == 1.56973);
  CHECK(refractive_index(ThesisLinear{}, 785.0) == Approx(1.54769).margin(5e-7));
  CHECK(refractive_index(ThesisLinear{}, 780.0) == Approx(1.5479624).margin(1e-7));
}

TEST_CASE("The thesis's third method is centred on the general index") {
  const ThesisScaled law{1.5, 2.0};
  CHECK(refractive_index(law, 380.0 + 202.5) == Approx(1.5).epsilon(1e-15));
  CHECK(refractive_index(law, 380.0) == Approx(1.5 + 0.02204).epsilon(1e-15));
  CHECK(refractive_index(law, 785.0) == Approx(1.5 - 0.02204).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(ThesisScaled{1.5, 0.0}));
  CHECK(refractive_index(ThesisScaled{1.5, 0.0}, 400.0) == 1.5);
  // With Vnum 1 and quartz's mean index it is the second method, shifted by a constant.
  const double shift =
      refractive_index(ThesisScaled{1.55871, 1.0}, 500.0) - refractive_index(ThesisLinear{}, 500.0);
  CHECK(shift == Approx(0.0).margin(5e-7));
}

TEST_CASE("Sellmeier's formula by hand") {
  // One term B = 1.25, C = 0.04 um^2 at 1 um: n^2 = 1 + 0.1 + 1.25/0.96.
  const Sellmeier law{0.1, {{1.25, 0.04}}};
  CHECK(refractive_index(law, 1000.0) == Approx(std::sqrt(1.1 + 1.25 / 0.96)).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(Sellmeier{1.25, {}}));
  CHECK(refractive_index(Sellmeier{1.25, {}}, 500.0) == 1.5);
}

TEST_CASE("A power series by hand") {
  // L = 1/2 um: 2.25 - 0.01/4 + 0.02 * 4.
  const PowerSeries law{2.25, {{-0.01, 2}, {0.02, -2}}};
  CHECK(refractive_index(law, 500.0) == Approx(std::sqrt(2.25 - 0.0025 + 0.08)).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(PowerSeries{2.25, {}}));
}

TEST_CASE("Formula 4 by hand") {
  // L = 1/2 um: 5 + 0.3 L^2/(L^2 - 0.05) + 0.01 L^-2.
  const Formula4 law{5.0, {{0.3, 2, 0.05}}, {{0.01, -2}}};
  CHECK(refractive_index(law, 500.0) ==
        Approx(std::sqrt(5.0 + 0.3 * 0.25 / 0.2 + 0.04)).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(Formula4{2.0, {}, {}}));
}

TEST_CASE("A gas by hand") {
  // L = 1/2 um, L^-2 = 4: 1 + 0.05/(200 - 4).
  const GasFormula law{0.0, {{0.05, 200.0}}};
  CHECK(refractive_index(law, 500.0) == Approx(1.0 + 0.05 / 196.0).epsilon(1e-15));
  CHECK_FALSE(is_achromatic(law));
  CHECK(is_achromatic(GasFormula{}));
}

TEST_CASE("The Abbe number is (n_d - 1)/(n_F - n_C)") {
  // For a straight line it is (n_d - 1)/(slope (C - F)), with the lines as tabulated.
  const double n_d = 1.56973 - 0.000054419 * (587.5618 - 380.0);
  CHECK(abbe_number(ThesisLinear{}) ==
        Approx((n_d - 1.0) / (0.000054419 * (656.2725 - 486.1327))).epsilon(1e-10));
}

TEST_CASE("Exaggeration keeps n_d and divides the Abbe number") {
  const Dispersion glass = Sellmeier{0.0, {{1.25, 0.01}}};
  const Dispersion strong = exaggerated(glass, 5.0);
  const double n_d = refractive_index(glass, kLineD_nm);
  CHECK(refractive_index(strong, kLineD_nm) == n_d);
  CHECK(abbe_number(strong) == Approx(abbe_number(glass) / 5.0).epsilon(1e-12));
  for (const double nm : {380.0, 500.0, 780.0})
    CHECK(refractive_index(strong, nm) ==
          Approx(n_d + 5.0 * (refractive_index(glass, nm) - n_d)).epsilon(1e-15));
  CHECK(exaggerated(strong, 2.0) == exaggerated(glass, 2.0)); // of the law, not of the law's
  CHECK(is_achromatic(exaggerated(glass, 0.0)));
  CHECK(is_achromatic(exaggerated(ConstantIndex{1.5}, 9.0)));
  CHECK_FALSE(is_achromatic(strong));
}
