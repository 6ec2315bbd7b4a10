#include "io/images/read_picture.h"
#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

#include <nlohmann/json.hpp>

#include <limits>

using namespace abbe;
using test::Desk;
using test::number_after;

namespace {

void write_grey(const std::filesystem::path& path, const std::vector<float>& values) {
  test::write_foreign_exr(path, static_cast<int>(values.size()), 1, {{"Y", values}});
}

} // namespace

TEST_CASE("diff measures a known difference") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.6F, 0.6F, 0.6F, 0.4F});
  write_grey(desk / "b.exr", {0.5F, 0.5F, 0.5F, 0.5F});
  const std::string text = desk.run("diff a.exr b.exr");
  CHECK(number_after(text, "RMSE, linear sRGB") == Approx(0.1).margin(1e-6));
  // 0.01 / (0.25 + 0.01 x 0.25) in every pixel.
  CHECK(number_after(text, "relMSE") == Approx(0.01 / 0.2525).epsilon(1e-5));
  // Greys differ in L* = 116 cbrt(Y) - 16 alone: those of 0.4 and 0.5, 69.470 and 76.069, by 6.599,
  // which CIEDE2000 divides by 1 + 0.015 d^2 / sqrt(20 + d^2) = 1.3352 with d = 22.77, the middle
  // less 50.
  const auto json = nlohmann::json::parse(desk.run("diff a.exr b.exr --json"));
  CHECK(json["delta_e_largest"].get<double>() == Approx(6.599 / 1.3352).epsilon(1e-3));
  CHECK(json["bands"].empty());
}

TEST_CASE("equal pictures do not differ, and the exit code follows the tolerance") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.6F, 0.6F});
  write_grey(desk / "b.exr", {0.5F, 0.5F});
  const std::string same = desk.run("diff a.exr a.exr --tolerance 0");
  CHECK(number_after(same, "RMSE, linear sRGB") == 0.0);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 0.11").exit_code == 0);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 0.09").exit_code == 1);
  CHECK(desk.abbe("diff a.exr b.exr").exit_code == 0);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 0.03 --measure relmse").exit_code == 1);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 0.05 --measure relmse").exit_code == 0);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 1 --measure de2000").exit_code == 1);
  CHECK(desk.abbe("diff a.exr b.exr --tolerance 9 --measure de2000-95").exit_code == 0);
}

TEST_CASE("a pixel without numbers is told, left out, and beyond any tolerance") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.5F, std::numeric_limits<float>::quiet_NaN()});
  write_grey(desk / "b.exr", {0.5F, 0.5F});
  const test::Outcome outcome = desk.abbe("diff a.exr b.exr --tolerance 1");
  CHECK(outcome.exit_code == 1);
  CHECK(number_after(outcome.out, "pixels without numbers") == 1.0);
  CHECK(number_after(outcome.out, "RMSE, linear sRGB") == 0.0);
}

TEST_CASE("a black reference makes relMSE infinite, unless the picture is black too") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.5F, 0.0F});
  write_grey(desk / "black.exr", {0.0F, 0.0F});
  CHECK(desk.run("diff a.exr black.exr").find("relMSE                  inf") != std::string::npos);
  CHECK(number_after(desk.run("diff black.exr black.exr"), "relMSE") == 0.0);
}

TEST_CASE("bands are compared one by one") {
  const Desk desk;
  test::write_foreign_exr(desk / "a.exr", 2, 1,
                          {{"S0.500nm", {1.0F, 3.0F}}, {"S0.600nm", {2.0F, 2.0F}}});
  test::write_foreign_exr(desk / "b.exr", 2, 1,
                          {{"S0.500nm", {2.0F, 2.0F}}, {"S0.600nm", {2.0F, 2.0F}}});
  CHECK(desk.run("diff a.exr b.exr --csv") ==
        "nm,rmse,relative\n500.000000,1,0.5\n600.000000,0,0\n");
  CHECK(desk.run("diff a.exr b.exr").find("the most different at 500.000 nm: 0.5 of") !=
        std::string::npos);
  CHECK(desk.run("diff a.exr b.exr --bands").find("   600.000             0  0") !=
        std::string::npos);
}

TEST_CASE("false colours go from violet to yellow") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.5F, 0.9F});
  write_grey(desk / "b.exr", {0.5F, 0.1F});
  CHECK(desk.abbe("diff a.exr b.exr -o d.png --most 5").exit_code == 0);
  const Picture picture = read_picture(desk / "d.png", {});
  REQUIRE(picture.part == PixelWindow{0, 0, 2, 1});
  // Codes 68, 1, 84 and 253, 231, 37 of 255, decoded.
  CHECK(picture.rgb[0] == Approx(0.0578).margin(1e-3));
  CHECK(picture.rgb[3] == Approx(0.9823).margin(1e-3));
  CHECK(picture.rgb[5] == Approx(0.0185).margin(1e-3));
}

TEST_CASE("diff refuses what is wrong") {
  const Desk desk;
  write_grey(desk / "a.exr", {0.5F, 0.9F});
  write_grey(desk / "wide.exr", {0.5F, 0.9F, 0.1F});
  write_grey(desk / "nan.exr", {std::numeric_limits<float>::quiet_NaN(), NAN});
  desk.refuses("diff a.exr wide.exr", "only pictures of the same pixels can be compared");
  desk.refuses("diff a.exr none.exr", "there is no file none.exr");
  desk.refuses("diff a.exr", "reference is required");
  desk.refuses("diff a.exr nan.exr", "have no pixel with numbers in both");
  desk.refuses("diff a.exr a.exr --tolerance -1", "--tolerance");
  desk.refuses("diff a.exr a.exr --measure rmse", "--measure");
  desk.refuses("diff a.exr a.exr --tolerance 1 --measure psnr", "psnr");
  desk.refuses("diff a.exr a.exr -o d.exr", "the name should end in .png");
  desk.refuses("diff a.exr a.exr --most 3", "--most");
  desk.refuses("diff a.exr a.exr --csv", "it has no bands for a comparison");
}
