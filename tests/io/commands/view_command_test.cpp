#include "tests/catch.h"
#include "tests/io/foreign_exr.h"
#include "tests/io/run_program.h"

#include <nlohmann/json.hpp>

using namespace abbe;
using test::content;
using test::Desk;
using test::write_foreign_exr;

namespace {

void write_two_bands(const std::filesystem::path& path) {
  write_foreign_exr(path, 2, 1, {{"S0.500,0nm", {1.0F, 2.0F}}, {"S0.600,0nm", {3.0F, 4.0F}}});
}

void write_layers(const std::filesystem::path& path) {
  write_foreign_exr(path, 1, 1,
                    {{"R", {1.0F}},
                     {"G", {0.5F}},
                     {"B", {0.25F}},
                     {"A", {1.0F}},
                     {"depth.Z", {7.0F}},
                     {"CryptoObject00.R", {0.0F}}});
}

/// What the page says of its pictures.
nlohmann::json index_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"index\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

} // namespace

TEST_CASE("view writes one page that needs no other file") {
  const Desk desk;
  write_two_bands(desk / "cube.exr");
  write_layers(desk / "layers.exr");
  const std::string said = desk.run("view cube.exr layers.exr -o page.html");
  CHECK(said.starts_with("wrote page.html: 2 pictures"));
  CHECK(said.find("off by at most 0.00076 %") != std::string::npos); // 1/131070
  const std::string page = content(desk / "page.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.find("http://") == std::string::npos);
  CHECK(page.find("https://") == std::string::npos);
  CHECK(page.find("src=") == std::string::npos);
  const nlohmann::json pictures = index_of(page)["pictures"];
  REQUIRE(pictures.size() == 2);
  CHECK(pictures[0]["name"] == "cube.exr");
  CHECK(pictures[0]["width"] == 2);
  CHECK(pictures[0]["nm"] == nlohmann::json({500.0, 600.0}));
  CHECK(pictures[0]["lengths"][0].size() == 4); // colours, ranges, two bands
  CHECK(pictures[1]["layers"] == nlohmann::json({"depth.Z"}));
}

TEST_CASE("view takes the pictures of a folder, by name") {
  const Desk desk;
  std::filesystem::create_directory(desk / "shots");
  write_two_bands(desk / "shots/b.exr");
  write_layers(desk / "shots/a.exr");
  test::put(desk / "shots/notes.txt", "no picture");
  desk.run("view shots");
  const nlohmann::json pictures = index_of(content(desk / "shots.html"))["pictures"];
  REQUIRE(pictures.size() == 2);
  CHECK(pictures[0]["name"] == "a.exr");
}

TEST_CASE("a picture's name cannot end the script that tells it") {
  const Desk desk;
  write_layers(desk / "<b>.exr");
  desk.run("view '<b>.exr' -o page.html");
  const std::string page = content(desk / "page.html");
  CHECK(page.find("<b>.exr") == std::string::npos);
  CHECK(index_of(page)["pictures"][0]["name"] == "<b>.exr");
}

TEST_CASE("view refuses what it cannot show") {
  const Desk desk;
  write_layers(desk / "a.exr");
  std::filesystem::create_directory(desk / "empty");
  desk.refuses("view nothing.exr", "there is no file nothing.exr");
  desk.refuses("view empty", "there is no picture in this folder");
  desk.refuses("view a.exr -o a.exr", "the name of a page should end in .html");
  write_foreign_exr(desk / "depth.exr", 1, 1, {{"depth.Z", {7.0F}}});
  desk.refuses("view depth.exr", "neither channels R, G and B, nor Y, nor bands");
}
