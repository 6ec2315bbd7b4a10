#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

#include <nlohmann/json.hpp>

using namespace abbe;
using test::Desk;

namespace {

/// 4 x 3 pixels, counted from 0 in both bands, the second times 10.
void write_counted(const std::filesystem::path& path) {
  std::vector<float> once, tenfold;
  for (int i = 0; i < 12; ++i) {
    once.push_back(static_cast<float>(i));
    tenfold.push_back(10.0F * static_cast<float>(i));
  }
  test::write_foreign_exr(path, 4, 3, {{"S0.500nm", once}, {"S0.600nm", tenfold}});
}

} // namespace

TEST_CASE("region tells means and standard deviations") {
  const Desk desk;
  write_counted(desk / "c.exr");
  // Columns 1 and 2 of rows 1 and 2: 5, 6, 9, 10 with the mean 7.5 and the deviation
  // sqrt((6.25 + 2.25 + 2.25 + 6.25) / 3) = 2.380476.
  const auto json = nlohmann::json::parse(desk.run("region c.exr 1 1 3 3 --json"));
  CHECK(json["pixels"] == 4);
  CHECK(json["nm"] == std::vector<double>{500.0, 600.0});
  CHECK(json["values"][0].get<double>() == 7.5);
  CHECK(json["values"][1].get<double>() == 75.0);
  CHECK(json["deviations"][0].get<double>() == Approx(2.3804761));
  CHECK(json["deviations"][1].get<double>() == Approx(23.804761));
  // All pixels are multiples of one spectrum, so that colours deviate by the same part.
  CHECK(json["XYZ_deviation"][1].get<double>() / json["XYZ"][1].get<double>() ==
        Approx(2.3804761 / 7.5));
  CHECK(desk.run("region c.exr 1 1 3 3 --csv") ==
        "nm,mean,deviation\n500.000000,7.5,2.38047614\n600.000000,75,23.8047614\n");
  CHECK(desk.run("region c.exr 1 1 3 3").find("4 pixels") != std::string::npos);
}

TEST_CASE("a region of one pixel has no deviation") {
  const Desk desk;
  write_counted(desk / "c.exr");
  const auto json = nlohmann::json::parse(desk.run("region c.exr 3 2 4 3 --json"));
  CHECK(json["values"][0] == 11.0);
  CHECK(json["deviations"][0] == 0.0);
}

TEST_CASE("region refuses what is wrong") {
  const Desk desk;
  write_counted(desk / "c.exr");
  desk.refuses("region c.exr 1 1 1 3", "holds no pixel");
  desk.refuses("region c.exr 3 1 1 3", "holds no pixel");
  desk.refuses("region c.exr 0 0 5 3", "is not within the picture");
  desk.refuses("region c.exr 0 0 4", "y1 is required");
  desk.refuses("region none.png 0 0 4 3", "there is no file none.png");
  test::write_foreign_exr(desk / "rgb.exr", 1, 1, {{"Y", {1.0F}}});
  desk.refuses("region rgb.exr 0 0 1 1 --csv", "it has no bands for --csv");
  test::write_foreign_exr(desk / "depth.exr", 1, 1, {{"Z", {1.0F}}});
  desk.refuses("region depth.exr 0 0 1 1", "it has neither channels R, G and B, nor Y, nor bands");
}
