#include "core/bands/index_table.h"
#include "spectral/glass.h"
#include "tests/catch.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace abbe;

namespace {

double largest_error(const Dispersion& law) {
  const IndexTable table(law);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> wavelength(kLowerNm, kUpperNm);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double nm = wavelength(random);
    worst = std::max(worst, std::abs(table.at(nm) - refractive_index(law, nm)));
  }
  return worst;
}

} // namespace

TEST_CASE("every glass of the catalogue is tabulated to better than 1e-7") {
  REQUIRE(glass_catalogue().size() > 50);
  for (const Glass& glass : glass_catalogue()) {
    INFO(glass.name);
    CHECK(largest_error(glass.dispersion) < 1e-7);
  }
}

TEST_CASE("the ends of the range are entries of the table") {
  const Dispersion& law = find_glass("SF11")->dispersion;
  const IndexTable table(law);
  CHECK(table.at(kLowerNm) == refractive_index(law, kLowerNm));
  CHECK(table.at(kUpperNm) == Approx(refractive_index(law, kUpperNm)).epsilon(1e-15));
  CHECK(table.at(380.0) == refractive_index(law, 380.0));
}

TEST_CASE("an achromatic medium is one number") {
  CHECK(IndexTable().achromatic());
  CHECK(IndexTable().at(500.0) == 1.0);
  const IndexTable constant(ThesisScaled{1.5, 0.0});
  CHECK(constant.achromatic());
  CHECK(constant.at(kLowerNm) == 1.5);
  CHECK_FALSE(IndexTable(ThesisScaled{1.5, 1.0}).achromatic());
}

TEST_CASE("an achromatic medium that is tabulated has the same index and stays achromatic") {
  const IndexTable table(ThesisScaled{1.7, 0.0}, false);
  CHECK(table.achromatic());
  for (const double lambda_nm : {kLowerNm, 400.01, 555.5, kUpperNm})
    CHECK(table.at(lambda_nm) == 1.7);
}
