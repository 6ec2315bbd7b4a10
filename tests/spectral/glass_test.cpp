#include "spectral/band_grid.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/spectral/expected.h"

#include <set>

using namespace abbe;

TEST_CASE("The catalogue has 103 distinct materials with a range and a source") {
  CHECK(glass_catalogue().size() == 103);
  std::set<std::string> names;
  for (const Glass& glass : glass_catalogue()) {
    INFO(glass.name);
    CHECK(names.insert(glass.name).second);
    CHECK(glass.lower_nm >= 100.0);
    CHECK(glass.upper_nm > glass.lower_nm + 200.0);
    CHECK_FALSE(glass.source.empty());
    CHECK(find_glass(glass.name) == &glass);
  }
}

TEST_CASE("The laws give the n_d and V_d of the makers' data sheets") {
  int compared = 0;
  for (const Glass& glass : glass_catalogue()) {
    if (!glass.published_source.starts_with("vendor data sheet")) continue;
    INFO(glass.name);
    REQUIRE(glass.n_d.has_value());
    REQUIRE(glass.v_d.has_value());
    CHECK(refractive_index(glass.dispersion, kLineD_nm) == Approx(*glass.n_d).margin(1e-5));
    CHECK(abbe_number(glass.dispersion) == Approx(*glass.v_d).margin(0.05));
    ++compared;
  }
  CHECK(compared == 72);
}

TEST_CASE("Other materials are near what handbooks say") {
  for (const Glass& glass : glass_catalogue()) {
    INFO(glass.name);
    if (glass.n_d)
      CHECK(refractive_index(glass.dispersion, kLineD_nm) == Approx(*glass.n_d).margin(2e-3));
  }
}

TEST_CASE("Laws of all kinds give the expected indices") {
  const test::Expected expected("golden_index.csv");
  CHECK(expected.row_count() == 72);
  for (int row = 0; row < expected.row_count(); ++row) {
    const Glass* glass = find_glass(expected.text(row, "name"));
    REQUIRE(glass != nullptr);
    INFO(glass->name << ' ' << expected.text(row, "nm"));
    CHECK(refractive_index(glass->dispersion, expected.number(row, "nm")) ==
          Approx(expected.number(row, "n")).epsilon(1e-11));
  }
  // Kinds that table lacks, from glass.csv's computed n380 and n780.
  const auto n = [](const char* name, double nm) {
    return refractive_index(find_glass(name)->dispersion, nm);
  };
  CHECK(n("ZnS-cubic", 380.0) == Approx(2.6040793).margin(1e-6));
  CHECK(n("TiO2-rutile-o", 380.0) == Approx(3.1178698).margin(1e-6));
  CHECK(n("air-15C", 380.0) == Approx(1.0002839).margin(1e-7));
  CHECK(n("PMMA", 380.0) == Approx(1.5106632).margin(1e-7));
  CHECK(n("calcite-o", 380.0) == Approx(1.6870183).margin(1e-7));
}

TEST_CASE("Every material has normal dispersion over all bands") {
  for (const Glass& glass : glass_catalogue()) {
    INFO(glass.name);
    for (double nm = kLowerNm; nm < kUpperNm; nm += 5.0)
      CHECK(refractive_index(glass.dispersion, nm) > refractive_index(glass.dispersion, nm + 5.0));
  }
}

TEST_CASE("Names of glasses ignore case, unknown ones give nothing") {
  CHECK(find_glass("n-bk7") == find_glass("N-BK7"));
  REQUIRE(find_glass("N-BK7") != nullptr);
  CHECK(find_glass("N-BK7")->lower_nm == Approx(300.0));
  CHECK(find_glass("N-BK7")->upper_nm == Approx(2500.0));
  CHECK(find_glass("BK") == nullptr);
}

TEST_CASE("Materials are found by what people call them") {
  CHECK(find_glass("Water") == find_glass("water-20C"));
  CHECK(find_glass("sapphire") == find_glass("sapphire-o"));
  CHECK(find_glass("window") == find_glass("soda-lime"));
  CHECK(find_glass("pyrites") == nullptr);
  const auto n = [](const char* name, double nm) {
    return refractive_index(find_glass(name)->dispersion, nm);
  };
  // The tables and formulas of the sources.
  CHECK(n("ice", 400.0) == Approx(1.3194).margin(1e-4));
  CHECK(n("ice", 550.0) == Approx(1.3110).margin(1e-4));
  CHECK(n("ice", 700.0) == Approx(1.3069).margin(1e-4));
  CHECK(n("soda-lime", 500.0) == Approx(1.5130 - 0.003169 * 0.25 + 0.003962 / 0.25).epsilon(1e-9));
  CHECK(n("zirconia", 589.3) == Approx(2.1586).margin(5e-4));
}
