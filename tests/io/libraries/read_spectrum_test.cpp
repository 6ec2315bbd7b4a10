#include "io/libraries/read_spectrum.h"

#include "spectral/band_grid.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

using namespace abbe;

namespace {

MeasuredSpectrum spectrum_of(const std::string& text, const char* file,
                             std::vector<std::string>* warnings = nullptr) {
  return read_spectrum_text(text, file, [&](const std::string& message) {
    if (warnings) warnings->push_back(message);
  });
}

std::string error_of(const std::string& text, const char* file) {
  try {
    (void)spectrum_of(text, file);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

/// As Argyll's spotread writes it, with four bands.
constexpr const char* kArgyll = R"(SPECT   

DESCRIPTOR "Argyll Spectral power/reflectance information"
ORIGINATOR "Argyll CMS"
KEYWORD "SPECTRAL_BANDS"
SPECTRAL_BANDS "4"
KEYWORD "SPECTRAL_START_NM"
SPECTRAL_START_NM "380.000000"
KEYWORD "SPECTRAL_END_NM"
SPECTRAL_END_NM "390.000000"
KEYWORD "SPECTRAL_NORM"
SPECTRAL_NORM "100.000000"

NUMBER_OF_FIELDS 4
BEGIN_DATA_FORMAT
SPEC_380 SPEC_383 SPEC_387 SPEC_390 
END_DATA_FORMAT

NUMBER_OF_SETS 1
BEGIN_DATA
10.0 20.0 30.0 40.0 
END_DATA
)";

} // namespace

TEST_CASE("a table of a spectrum has two columns, whatever stands between them") {
  for (const char* text :
       {"nm,power\n380,0.5\n381.5,1e-2\n", "\xEF\xBB\xBF# lamp\r\n380\t0.5\r\n381.5\t0.01\r\n",
        "Wellenl\xC3\xA4nge;Leistung\n380;0,5\n381,5;0,01", "380 0.5\n\n381.5   .01\n"}) {
    const MeasuredSpectrum spectrum = spectrum_of(text, "lamp.csv");
    CHECK(spectrum.nm == std::vector{380.0, 381.5});
    CHECK(spectrum.values == std::vector{0.5, 0.01});
  }
}

TEST_CASE("columns beyond the second are told") {
  std::vector<std::string> warnings;
  (void)spectrum_of("380 1 2\n400 1 2\n", "a.txt", &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0] == "a.txt:1:1: of 3 columns the second is taken");
}

TEST_CASE("Argyll's spectra are read with their norm, and wavelengths that names round") {
  const MeasuredSpectrum spectrum = spectrum_of(kArgyll, "a.sp");
  REQUIRE(spectrum.nm.size() == 4);
  CHECK(spectrum.nm[1] == Approx(380.0 + 10.0 / 3.0));
  CHECK(spectrum.nm[3] == 390.0);
  CHECK(spectrum.values[0] == Approx(0.1));
  CHECK(spectrum.values[3] == Approx(0.4));
}

TEST_CASE("CGATS names of fields tell the wavelengths where nothing else does") {
  const MeasuredSpectrum spectrum = spectrum_of(
      "CGATS.17\nBEGIN_DATA_FORMAT\nSAMPLE_ID nm400 nm410\nEND_DATA_FORMAT\nBEGIN_DATA\n1 .2 .3\n"
      "END_DATA\n",
      "chart.cgats");
  CHECK(spectrum.nm == std::vector{400.0, 410.0});
  CHECK(spectrum.values == std::vector{0.2, 0.3});
}

TEST_CASE("IES TM-27 is read, several points on a line or one") {
  const MeasuredSpectrum spectrum = spectrum_of(
      "<?xml version=\"1.0\"?>\n<IESTM2714 xmlns=\"iestm2714\" version=\"1.0\">\n"
      "<SpectralDistribution><SpectralQuantity>flux</SpectralQuantity>\n"
      "<SpectralData wavelength=\"400.5\">0.034</SpectralData>"
      "<SpectralData wavelength='401'> 0.037 </SpectralData>\n"
      "<SpectralData wavelength=\"402\">1</SpectralData>\n</SpectralDistribution></IESTM2714>",
      "led.spdx");
  CHECK(spectrum.nm == std::vector{400.5, 401.0, 402.0});
  CHECK(spectrum.values == std::vector{0.034, 0.037, 1.0});
}

TEST_CASE("a lamp of a file has Y = 1 and its bands are exact means") {
  const test::Folder folder;
  test::put(folder.path / "peak.csv", "377 0\n400 0\n402 1\n404 0\n790 0\n");
  const Token name{TokenKind::word, "peak.csv", {(folder.path / "s.sdl").string(), 1, 7}};
  const Curve lamp = read_lamp(name, {});
  CHECK(to_xyz(lamp).y == Approx(1.0));
  // A triangle of half-width 2 nm and height 1: its area is 2. Of this 400 to 402.5 nm holds
  // 2 - (404 - 402.5)^2 / 4 = 1.4375, and the next cell of 5 nm the rest.
  const std::vector<double> means = band_means(BandGrid(81), lamp);
  CHECK(means[4] / means[5] == Approx(1.4375 / 0.5625));
  // In cells of 1 nm: 401.5 to 402.5 nm holds 1 - 2 * 0.5^2 / 4.
  const std::vector<double> fine = band_means(BandGrid(405), lamp);
  CHECK(fine[24] / means[4] == Approx(0.875 / (1.4375 / 5.0)));
}

TEST_CASE("a reflectance of a file is one: from 0 to 1") {
  const test::Folder folder;
  test::put(folder.path / "r.csv", "380 0.25\n480 0.25\n680 1.02\n780 1.02\n");
  test::put(folder.path / "percent.csv", "380 25\n780 98\n");
  const auto name = [&](const char* file) {
    return Token{TokenKind::word, file, {(folder.path / "s.sdl").string(), 1, 9}};
  };
  std::vector<std::string> warnings;
  const Curve curve =
      read_reflectance(name("r.csv"), [&](const auto& m) { warnings.push_back(m); });
  CHECK(curve.at(400.0) == 0.25);
  CHECK(curve.at(580.0) == Approx(0.625));
  CHECK(curve.at(740.0) == 1.0);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].ends_with("2 values of r.csv lie outside 0 to 1 and count as 0 or 1"));
  CHECK_THROWS_AS(read_reflectance(name("percent.csv"), {}), ReadError);
}

TEST_CASE("what is wrong with a spectrum is told at its line") {
  CHECK(
      error_of("380 1\n400 x\n", "a.csv") ==
      "a.csv:2:1: a wavelength and a value should stand here (\"400 x\" is not two numbers). Give "
      "a line with two columns for each wavelength, in nm");
  CHECK(error_of("380 1\n380 2\n", "a.csv") ==
        "a.csv:2:1: the wavelengths do not ascend (380 follows 380). Sort the lines, each "
        "wavelength once");
  CHECK(error_of("0.38 1\n0.4 2\n", "a.csv") ==
        "a.csv:1:1: no wavelength of the file is visible (they run from 0.38 to 0.4). Give "
        "wavelengths in nm");
  CHECK(error_of("\n", "a.csv") == "a.csv: the file holds no spectrum (it has 0 wavelengths). Give "
                                   "at least two wavelengths in nm, each with its value");
  CHECK(
      error_of("SPECT\nBEGIN_DATA\n1\nEND_DATA\n", "a.sp") ==
      "a.sp:4:1: the file has no spectral fields (such as SPEC_380 after BEGIN_DATA_FORMAT). Give "
      "a file that was measured with spectra");
  CHECK(error_of("<SpectralData wavelength=\"x\">1</SpectralData>", "a.spdx")
            .starts_with("a.spdx:1:1: this SpectralData holds no point"));
}
