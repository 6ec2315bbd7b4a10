#include "tests/catch.h"
#include "tests/io/run_program.h"

#include <cmath>
#include <fstream>
#include <sstream>

using namespace abbe;
using test::Desk;
using test::number_after;

namespace {

/// The numbers of the line of a table of values that begins with this one.
std::vector<double> row_at(const std::string& csv, double nm) {
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<double> row;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      row.push_back(std::strtod(field.c_str(), nullptr));
    if (!row.empty() && std::abs(row.front() - nm) < 1e-6) return row;
  }
  return {};
}

/// Schott's N-BK7: n^2 - 1 = sum B L^2 / (L^2 - C), so that n dn/dL = -sum B C L / (L^2 - C)^2, L
/// in um.
struct NBk7 {
  double n, slope;
};
NBk7 n_bk7(double um) {
  constexpr double b[] = {1.03961212, 0.231792344, 1.01046945};
  constexpr double c[] = {0.00600069867, 0.0200179144, 103.560653};
  double square = 1.0, slope = 0.0;
  for (int i = 0; i < 3; ++i) {
    square += b[i] * um * um / (um * um - c[i]);
    slope -= b[i] * c[i] * um / std::pow(um * um - c[i], 2.0);
  }
  return {std::sqrt(square), slope / std::sqrt(square)};
}

} // namespace

TEST_CASE("glass tells n and its slope as Schott's formula has them") {
  const Desk desk;
  const std::string csv = desk.run("glass N-BK7 --csv --step 40");
  for (const double nm : {380.0, 420.0, 580.0, 780.0}) {
    const std::vector<double> row = row_at(csv, nm);
    REQUIRE(row.size() == 4);
    const NBk7 expected = n_bk7(nm * 1e-3);
    CHECK(row[1] == Approx(expected.n).margin(1e-8));
    CHECK(row[2] == Approx(expected.slope).epsilon(1e-5));
    // Two surfaces that reflect r each, to and fro: (1 - r) / (1 + r).
    const double r = std::pow((expected.n - 1.0) / (expected.n + 1.0), 2.0);
    CHECK(row[3] == Approx((1.0 - r) / (1.0 + r)).margin(1e-8));
  }
}

TEST_CASE("glass puts two side by side, by any case of their names") {
  const Desk desk;
  const std::string text = desk.run("glass n-bk7 F2");
  // By Schott's formula; V_d 64.17 and 36.37.
  CHECK(text.find("n_d  587.5618 nm      1.516800                      1.620040") !=
        std::string::npos);
  CHECK(text.find("V_d                   64.17                         36.37") !=
        std::string::npos);
  CHECK(text.find("range in nm           300 to 2500") != std::string::npos);
  CHECK(text.find("N-BK7: coefficients: SCHOTT") != std::string::npos);
  CHECK(desk.run("glass N-BK7 F2 --csv").starts_with("nm,n N-BK7,dn/dum N-BK7,plate N-BK7,n F2,"));
}

TEST_CASE("glass marks what lies beyond a glass's range") {
  const Desk desk;
  const std::string text = desk.run("glass SK16 --step 200"); // coefficients for 400 to 700 nm
  CHECK(text.find("*: beyond the range of the coefficients of SK16") != std::string::npos);
  CHECK(desk.run("glass N-BK7").find('*') == std::string::npos);
}

// The glass lets 0.9 of 400 nm pass through 10 mm, so 0.81 through 20 mm (Lambert's law).
TEST_CASE("glass tells what a maker's glass lets pass, and of others that it does not know") {
  const Desk desk;
  CHECK(desk.run("glass N-BK7").find("absorption            not known") != std::string::npos);
  std::ofstream(desk / "maker.agf") << "CC a catalogue\n"
                                       "NM DARK 2 517642.251 1.5168 64.17 0 1\n"
                                       "CD 1.03961212 0.00600069867 0.231792344 0.0200179144 "
                                       "1.01046945 103.560653\n"
                                       "LD 0.3 2.5\n"
                                       "IT 0.40 0.9 10\nIT 0.50 0.998 10\n";
  const std::string csv = desk.run("glass dark --glasses maker.agf --csv --thickness 20");
  CHECK(csv.starts_with("nm,n DARK,dn/dum DARK,plate DARK,internal DARK"));
  const std::vector<double> row = row_at(csv, 400.0);
  REQUIRE(row.size() == 5);
  CHECK(row[4] == Approx(0.81).epsilon(1e-7));
  CHECK(desk.run("glass N-BK7 DARK --glasses maker.agf").find("what 10 mm of DARK let pass") !=
        std::string::npos);
  desk.refuses("glass DARK --glasses none.agf", "none.agf");
  desk.refuses("glass DARK --glasses maker.agf --thickness 0", "--thickness");
}

TEST_CASE("glass refuses what is wrong") {
  const Desk desk;
  desk.refuses("glass N-BK8", "there is no glass \"N-BK8\". Did you mean N-BK7");
  desk.refuses("glass N-BK7 unobtainium", "abbe list glasses shows all");
  desk.refuses("glass", "names is required");
  desk.refuses("glass N-BK7 F2 SF11", "");
  desk.refuses("glass N-BK7 --step 0", "--step");
  desk.refuses("glass N-BK7 --step x", "--step");
}
