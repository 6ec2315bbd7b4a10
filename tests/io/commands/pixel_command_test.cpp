#include "spectral/illuminant.h"
#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace abbe;
using test::Desk;
using test::number_after;
using test::write_foreign_exr;

namespace {

/// Two pixels: D65 at 5 nm, and light of 535 nm alone in bands of 1 nm cannot be in one file, so
/// each has its own.
void write_d65(const std::filesystem::path& path) {
  const Curve d65 = *find_illuminant("D65");
  std::vector<test::ForeignChannel> channels;
  for (int nm = 380; nm <= 780; nm += 5)
    channels.push_back({fmt::format("S0.{},000000nm", nm), {static_cast<float>(d65.at(nm)), 0.0F}});
  write_foreign_exr(path, 2, 1, channels);
}

void write_laser(const std::filesystem::path& path) {
  std::vector<test::ForeignChannel> channels;
  for (int nm = 525; nm <= 545; ++nm)
    channels.push_back({fmt::format("S0.{}nm", nm), {nm == 535 ? 2.0F : 0.0F}});
  write_foreign_exr(path, 1, 1, channels);
}

void write_colors(const std::filesystem::path& path) {
  write_foreign_exr(
      path, 3, 1,
      {{"R", {1.0F, 0.0F, 0.5F}}, {"G", {0.0F, 1.0F, 0.5F}}, {"B", {0.0F, 0.0F, 0.5F}}});
}

} // namespace

TEST_CASE("pixel tells the colour of daylight") {
  const Desk desk;
  write_d65(desk / "d65.exr");
  const std::string text = desk.run("pixel d65.exr 0 0");
  CHECK(number_after(text, "x y") == Approx(0.3127).margin(1e-4));    // [CIE15]
  CHECK(number_after(text, "u' v'") == Approx(0.1978).margin(1e-4));  // [CIE15]
  CHECK(number_after(text, "X Y Z") == Approx(0.95047).margin(5e-4)); // [CIE15], Y = 1
  CHECK(number_after(text, "correlated temperature") == Approx(6504).margin(1.5));
  CHECK(number_after(text, "   380.000") ==
        Approx(find_illuminant("D65")->at(380.0)).epsilon(1e-5));
  const auto json = nlohmann::json::parse(desk.run("pixel d65.exr 0 0 --json"));
  CHECK(json["duv"].get<double>() == Approx(0.0032).margin(1e-4)); // Ohno's method of 2013
  CHECK(json["nm"].size() == 81);
  CHECK(json["values"][80].get<double>() == Approx(find_illuminant("D65")->at(780.0)));
  CHECK(json["white"][0] == 0.3127);
  const std::string csv = desk.run("pixel d65.exr 0 0 --csv");
  CHECK(csv.starts_with("nm,value\n380.000000,"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 82);
}

TEST_CASE("pixel sees bands with either observer") {
  const Desk desk;
  write_d65(desk / "d65.exr");
  const std::string text = desk.run("pixel d65.exr 0 0 --observer 10deg");
  CHECK(number_after(text, "x y") == Approx(0.3138).margin(1e-4)); // [CIE15]
  CHECK(text.find("correlated temperature  -") != std::string::npos);
}

TEST_CASE("pixel tells the wavelength of a laser") {
  const Desk desk;
  write_laser(desk / "laser.exr");
  const std::string text = desk.run("pixel laser.exr 0 0");
  CHECK(number_after(text, "dominant wavelength") == Approx(535.0).margin(0.02));
  // Between channels 1 nm apart the spectrum is linear: a triangle, and not quite one wavelength.
  CHECK(text.find("purity 0.999") != std::string::npos);
  // ybar(535 nm) = 0.9149 over 106.857, the sum of all. [CIE018]
  const auto json = nlohmann::json::parse(desk.run("pixel laser.exr 0 0 --json"));
  CHECK(json["XYZ"][1].get<double>() == Approx(2.0 * 0.91486 / 106.857).epsilon(1e-3));
}

TEST_CASE("pixel tells a difference, and what a grey is not") {
  const Desk desk;
  write_colors(desk / "c.exr");
  // Red and green of sRGB: L*a*b* 53.24 80.09 67.20 and 87.73 -86.18 83.18, CIEDE2000 86.61, as
  // colour calculators have them (www.brucelindbloom.com).
  const std::string text = desk.run("pixel c.exr 0 0 --to 1 0");
  CHECK(number_after(text, "CIEDE2000") == Approx(86.61).margin(0.02));
  CHECK(number_after(text, "L* a* b*") == Approx(53.24).margin(0.01));
  const std::string grey = desk.run("pixel c.exr 2 0");
  CHECK(grey.find("dominant wavelength     -") != std::string::npos);
  CHECK(number_after(grey, "linear sRGB") == Approx(0.5));
  // Under another white it has one.
  CHECK(desk.run("pixel c.exr 2 0 --white A").find("dominant wavelength     4") !=
        std::string::npos);
}

TEST_CASE("pixel draws the spectrum") {
  const Desk desk;
  write_d65(desk / "d65.exr");
  const test::Outcome outcome = desk.abbe("pixel d65.exr 0 0 --csv --plot d65.png");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.error == "wrote d65.png\n");
  CHECK(outcome.out.starts_with("nm,value\n"));
  CHECK(test::content(desk / "d65.png").substr(1, 3) == "PNG");
}

TEST_CASE("black has no chromaticity") {
  const Desk desk;
  write_d65(desk / "d65.exr");
  const std::string text = desk.run("pixel d65.exr 1 0");
  CHECK(text.find("x y                     -") != std::string::npos);
  CHECK(nlohmann::json::parse(desk.run("pixel d65.exr 1 0 --json"))["xy"].is_null());
}

TEST_CASE("line tells the pixels between two, both included") {
  const Desk desk;
  write_colors(desk / "c.exr");
  const std::string csv = desk.run("line c.exr 2 0 0 0 --csv");
  CHECK(csv.starts_with("x,y,X,Y,Z\n2,0,"));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
  // The luminance of sRGB's red is 0.2126.
  const auto json = nlohmann::json::parse(desk.run("line c.exr 0 0 2 0 --json"));
  REQUIRE(json["pixels"].size() == 3);
  CHECK(json["pixels"][0]["XYZ"][1].get<double>() == Approx(0.2126).margin(1e-4));
  CHECK(json["pixels"][2]["x"] == 2);
  CHECK(desk.run("line c.exr 0 0 1 0").find("     1      0") != std::string::npos);
}

TEST_CASE("line and pixel refuse what is wrong") {
  const Desk desk;
  write_colors(desk / "c.exr");
  desk.refuses("pixel c.exr 3 0",
               "the pixel 3, 0 is not within the picture, which holds the pixels "
               "x 0 to 2 and y 0 to 0");
  desk.refuses("pixel c.exr -1 0", "the pixel -1, 0 is not within the picture");
  desk.refuses("line c.exr 0 0 0 1", "the pixel 0, 1 is not within the picture");
  desk.refuses("pixel none.exr 0 0", "there is no file none.exr");
  desk.refuses("pixel c.exr 0", "y is required");
  desk.refuses("pixel c.exr 0 0 --csv", "it has no bands for --csv");
  desk.refuses("pixel c.exr 0 0 --plot a.png", "it has no bands for --plot");
  desk.refuses("pixel c.exr 0 0 --plot a.exr", "the name should end in .png");
  desk.refuses("pixel c.exr 0 0 --observer 10deg", "it has no bands that an observer could see");
  desk.refuses("pixel c.exr 0 0 --observer 5deg", "--observer");
  desk.refuses("pixel c.exr 0 0 --white D66", "\"D66\" is not a white");
  desk.refuses("pixel c.exr 0 0 --white none", "\"none\" is not a white");
  desk.refuses("pixel c.exr 0 0 --csv --json", "--csv");
  desk.refuses("pixel c.exr 0 0 --to 1", "--to");
}
