#include "io/libraries/read_glass_files.h"

#include "io/libraries/glass_formulas.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"

#include <cmath>
#include <stdexcept>

using namespace abbe;

namespace {

std::vector<FileGlass> catalogue_of(const std::string& text,
                                    std::vector<std::string>* warnings = nullptr) {
  return read_agf_text(text, "x.agf", [&](const std::string& message) {
    if (warnings) warnings->push_back(message);
  });
}

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

constexpr const char* kBk7 = "CC a catalogue\n"
                             "NM N-BK7 2 517642.251 1.5168 64.17 0 1\n"
                             "ED 7.1 8.3 2.51 -0.0009 0\n"
                             "CD 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 "
                             "103.560653\n"
                             "LD 0.3 2.5\n"
                             "IT 0.40 0.990 10\n"
                             "IT 0.50 0.998 10\n";

} // namespace

TEST_CASE("a glass of a catalogue has its index, range and absorption") {
  std::string wide = "\xFF\xFE"; // Zemax also writes UTF-16
  for (const char* c = kBk7; *c; ++c)
    wide += {*c, '\0'};
  for (const std::string& text : {std::string(kBk7), wide}) {
    const auto glasses = catalogue_of(text);
    REQUIRE(glasses.size() == 1);
    const FileGlass& bk7 = glasses[0];
    CHECK(bk7.glass.name == "N-BK7");
    // Schott's data sheet.
    CHECK(refractive_index(bk7.glass.dispersion, kLineD_nm) == Approx(1.5168).margin(5e-7));
    CHECK(abbe_number(bk7.glass.dispersion) == Approx(64.17).margin(5e-3));
    CHECK(bk7.glass.lower_nm == Approx(300.0));
    CHECK(bk7.glass.upper_nm == Approx(2500.0));
    CHECK(bk7.absorption_per_mm.at(400.0) == Approx(-std::log(0.99) / 10.0));
    CHECK(bk7.absorption_per_mm.at(600.0) == Approx(-std::log(0.998) / 10.0));
  }
}

TEST_CASE("each formula of the catalogues gives what it says") {
  // At L = 0.5 um, worked out by hand: L^2 = 1/4.
  const auto n = [](int formula, std::vector<double> c) {
    return refractive_index(agf_law(formula, c), 500.0);
  };
  CHECK(n(1, {2.25, 0.4, 0.01}) == Approx(std::sqrt(2.25 + 0.1 + 0.04)));
  CHECK(n(2, {1.2, 0.01}) == Approx(std::sqrt(1.0 + 1.2 * 0.25 / 0.24)));
  CHECK(n(3, {1.5, 0.0222, 0.0, 0.04}) == Approx(1.5 + 0.0222 / 0.222 + 0.01));
  CHECK(n(4, {0.1, 1.0, 0.1, 0.024, 0.1}) == Approx(std::sqrt(1.1 + 0.25 / 0.24 + 0.024 / 0.24)));
  CHECK(n(5, {1.5, 0.01, 0.001}) == Approx(1.5 + 0.02 + 0.001 * std::pow(2.0, 3.5)));
  CHECK(n(6, {0.5, 0.01, 0.5, 0.01, 0.0, 0.0, 0.2, 0.01}) ==
        Approx(std::sqrt(1.0 + 1.2 * 0.25 / 0.24)));
  CHECK(n(7, {2.0, 0.12, 0.01, 0.4}) == Approx(std::sqrt(2.0 + 0.5 - 0.1)));
  CHECK(n(8, {2.0, 0.24, 0.01, 0.4}) == Approx(std::sqrt(2.0 + 0.25 - 0.1)));
  CHECK(n(9, {2.0, 0.24, 0.01, 0.24, -0.05}) == Approx(std::sqrt(2.0 + 0.25 + 0.06 / 0.3)));
  CHECK(n(10, {2.0, 0, 0, 0, 0, 0, 0.001, 0.0001}) == Approx(std::sqrt(2.0 + 1.024 + 0.4096)));
  CHECK(n(11, {0, 0, 0, 0, 0, 0, 0, 0, 1.2, 0.01}) == Approx(std::sqrt(1.0 + 1.25)));
  CHECK(n(12, {2.0, 0, 0, 0, 0, 0, 1.6, 6.4}) == Approx(std::sqrt(2.0 + 0.1 + 0.1)));
  CHECK(n(13, {2.0, 0.4, 1.6, 0.01, 0, 0, 0, 0, 0.0001}) ==
        Approx(std::sqrt(2.0 + 0.1 + 0.1 + 0.04 + 0.4096)));
  CHECK_THROWS_AS(n(14, {1.5}), std::invalid_argument);
  CHECK_THROWS_AS(n(1, {-1.0}), std::invalid_argument);
}

TEST_CASE("each formula of refractiveindex.info gives what it says") {
  const auto n = [](int formula, std::vector<double> c) {
    return refractive_index(refractiveindex_law(formula, c), 500.0);
  };
  CHECK(n(1, {0.1, 1.2, 0.1}) == Approx(std::sqrt(1.1 + 1.2 * 0.25 / 0.24)));
  CHECK(n(2, {0.1, 1.2, 0.01}) == Approx(std::sqrt(1.1 + 1.2 * 0.25 / 0.24)));
  CHECK(n(3, {2.0, 0.4, 2, 0.01, -2}) == Approx(std::sqrt(2.0 + 0.1 + 0.04)));
  CHECK(n(3, {2.0, 0.4, 1.5}) == Approx(std::sqrt(2.0 + 0.4 * std::pow(0.5, 1.5))));
  CHECK(n(4, {2.0, 0.24, 0, 0.1, 2, 0.24, 2, 0.01, 1, 0.4, 2}) ==
        Approx(std::sqrt(2.0 + 1.0 + 0.25 + 0.1)));
  CHECK(n(5, {1.5, 0.004, -2, 0.001, -4}) == Approx(1.5 + 0.016 + 0.016));
  CHECK(n(6, {0.0001, 0.01, 104.0}) == Approx(1.0 + 0.0001 + 0.01 / 100.0));
  CHECK(n(7, {1.5, 0.0222, 0.0, 0.04}) == Approx(1.5 + 0.1 + 0.01));
  // (n^2 - 1) / (n^2 + 2) = 0.25 is n^2 = 2.
  CHECK(n(8, {0.2, 0.024, 0.01, 0.1}) == Approx(std::sqrt(2.0)));
  CHECK(n(9, {2.0, 0.024, 0.01, 0.1, 0.4, 0.09}) == Approx(std::sqrt(2.0 + 0.1 + 0.01 / 0.1)));
}

TEST_CASE("a table per nm is as good as the formula") {
  const Dispersion table = refractiveindex_law(5, std::vector{1.5, 0.0042, -2.0});
  for (double nm = 380.3; nm < 780.0; nm += 7.7)
    CHECK(refractive_index(table, nm) == Approx(1.5 + 0.0042 / (1e-6 * nm * nm)).margin(1e-8));
}

TEST_CASE("ice is read from a table of n and k") {
  // Rows of Warren and Brandt 2008, as refractiveindex.info gives them.
  const char* text = "REFERENCES: |\n    A: B\nDATA:\n  - type: tabulated nk\n    data: |\n"
                     "        5.000E-001 1.3130 5.889E-010\n        6.000E-001 1.3094 5.730E-009\n"
                     "SPECS:\n    temperature: -7\n";
  const RefractiveIndexFile ice = read_refractiveindex_text(text, "ice.yml");
  REQUIRE(ice.n);
  REQUIRE(ice.k);
  CHECK(refractive_index(*ice.n, 600.0) == 1.3094);
  CHECK(ice.k->at(500.0) == 5.889e-10);
  CHECK(ice.lower_nm == Approx(500.0));
}

TEST_CASE("what is wrong with a glass file is told at its line") {
  CHECK(error_of([] { (void)catalogue_of("CC nothing\n"); }) ==
        "x.agf:1:1: the catalogue holds no glass (no line begins with NM). Give a glass catalogue "
        "in Zemax's format");
  CHECK(error_of([] { (void)catalogue_of("NM X 2 1 1.5 60\nCD 1 a\n"); }) ==
        "x.agf:2:1: \"a\" is not a number (one should stand here). Check the line");
  CHECK(error_of([] { (void)catalogue_of("NM X 77 1 1.5 60\n"); }) ==
        "x.agf:1:1: 77 names no formula (formulas have the numbers 1 to 13). Check the line");
  CHECK(error_of([] {
          (void)read_refractiveindex_text("DATA:\n", "w.yml");
        }).starts_with("w.yml: the file gives no refractive index"));
  CHECK(error_of([] {
          (void)read_refractiveindex_text("DATA:\n  - type: formula 2\n    coefficients: 0 1\n",
                                          "w.yml");
        }).starts_with("w.yml:2:1: \"formula 2\" gives no index"));
  std::vector<std::string> warnings;
  (void)catalogue_of(std::string("NM IR 1 1 4 60\nCD -1\n") + kBk7, &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "x.agf:1:1: glass IR is left out: its index is no number above 0 in the "
                       "visible range");
}
