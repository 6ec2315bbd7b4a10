#include "spectral/dispersion.h"
#include "spectral/fit_index.h"
#include "spectral/glass.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

namespace {

struct Table {
  std::vector<double> nm, n;
};

Table measured(const char* name, double step_nm) {
  const Dispersion& law = find_glass(name)->dispersion;
  Table table;
  for (double nm = 380.0; nm <= 780.0; nm += step_nm) {
    table.nm.push_back(nm);
    table.n.push_back(refractive_index(law, nm));
  }
  return table;
}

} // namespace

TEST_CASE("A fit finds the law its points were made from") {
  const PowerSeries law{2.27, {{0.011, -2}, {0.0002, -4}, {-0.012, 2}}};
  std::vector<double> nm, n;
  for (const double at : {380.0, 420.0, 470.0, 530.0, 600.0, 690.0, 780.0}) {
    nm.push_back(at);
    n.push_back(refractive_index(law, at));
  }
  const IndexFit fit = fit_index(nm, n);
  CHECK(fit.largest_residual < 1e-14);
  CHECK(fit.law.constant == Approx(2.27).epsilon(1e-10));
  CHECK(fit.law.terms.at(0).coefficient == Approx(0.011).epsilon(1e-8));
  CHECK(fit.law.terms.at(1).coefficient == Approx(0.0002).epsilon(1e-6));
  CHECK(fit.law.terms.at(2).coefficient == Approx(-0.012).epsilon(1e-8));
}

TEST_CASE("Quartz is fitted where the thesis's quintic failed") {
  const Table table = measured("crystal-quartz-o", 50.0);
  const IndexFit fit = fit_index(table.nm, table.n);
  CHECK(fit.largest_residual < 2e-6);
  for (double nm = 380.0; nm <= 780.0; nm += 5.0)
    CHECK(refractive_index(fit.law, nm) ==
          Approx(refractive_index(find_glass("crystal-quartz-o")->dispersion, nm)).margin(5e-6));
  CHECK(refractive_index(fit.law, 589.0) == Approx(1.544).margin(5e-4));
  CHECK(refractive_index(ThesisPolynomial{}, 589.0) < 1.45);
}

TEST_CASE("Three lines of a data sheet are fitted exactly") {
  const IndexFit fit = fit_index({kLineF_nm, kLineD_nm, kLineC_nm}, {1.52238, 1.5168, 1.51432});
  CHECK(fit.largest_residual < 1e-14);
  CHECK(abbe_number(fit.law) == Approx(0.5168 / (1.52238 - 1.51432)).epsilon(1e-10));
  CHECK(is_achromatic(fit_index({550.0}, {1.5}).law));
  CHECK(refractive_index(fit_index({550.0}, {1.5}).law, 700.0) == Approx(1.5).epsilon(1e-15));
}

TEST_CASE("A fit tells its largest residual and where it is") {
  Table table = measured("N-BK7", 20.0);
  table.n[7] += 0.01; // 520 nm
  const IndexFit fit = fit_index(table.nm, table.n);
  CHECK(fit.worst_nm == 520.0);
  CHECK(fit.largest_residual ==
        Approx(std::abs(refractive_index(fit.law, 520.0) - table.n[7])).epsilon(1e-12));
  CHECK(fit.largest_residual > 5e-3);
}

TEST_CASE("Fits that make no sense are refused") {
  CHECK_THROWS_AS(fit_index({}, {}), std::invalid_argument);
  CHECK_THROWS_AS(fit_index({400.0}, {1.5, 1.6}), std::invalid_argument);
  CHECK_THROWS_AS(fit_index({400.0, 400.0}, {1.5, 1.6}), std::invalid_argument);
  CHECK_THROWS_AS(fit_index({400.0}, {-1.5}), std::invalid_argument);
}
