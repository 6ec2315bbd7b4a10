#include "io/libraries/standard_lights.h"

#include "spectral/illuminant.h"
#include "spectral/line_lamp.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

#include <fstream>

using namespace abbe;

namespace {

std::optional<Curve> lamp(const std::string& name) {
  return standard_light({TokenKind::word, name, {"s.sdl", 1, 1}});
}

} // namespace

TEST_CASE("lamps by temperature and wavelength need no library") {
  CHECK(lamp("D65") == find_illuminant("D65"));
  CHECK(lamp("BlackBody(5778)") == blackbody(5778.0));
  CHECK(lamp("daylight(6500)") == cie_daylight(6500.0));
  CHECK(lamp("line(632.8)") == line_lamp(632.8));
  CHECK(lamp("sodium") == sodium_lamp());
  CHECK_FALSE(lamp("neon").has_value());
  CHECK_FALSE(lamp("neon(3)").has_value());
  for (const std::string& name : standard_light_names()) {
    INFO(name);
    CHECK(lamp(name).has_value());
    CHECK(is_standard_light(name));
  }
  CHECK_FALSE(is_standard_light("neon"));
}

TEST_CASE("lamps stand wherever a light is named") {
  const Scene scene = scene_of("background line(500) 0.5 globalAmbient sodium\n"
                               "light blackbody(2856) 0 5 0 1 emissive daylight(5000) 2 sphere");
  CHECK(scene.background == line_lamp(500.0).scaled(0.5));
  CHECK(scene.global_ambient == sodium_lamp());
  CHECK(scene.lights.at(0).spectrum == blackbody(2856.0));
  CHECK(scene.lights.at(0).name == "blackbody(2856)");
  CHECK(scene.materials.at(0).emission == cie_daylight(5000.0).scaled(2.0));
}

TEST_CASE("a library's light wins over a lamp of its name, with a warning") {
  const auto folder = std::filesystem::temp_directory_path() / "abbe_lamp_test";
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / "lights.filter");
  for (const char* name : {"sodium", "blackbody(3000)"}) {
    file << "filter " << name << " { colour 81";
    for (int i = 0; i < 81; ++i)
      file << " 0.25";
    file << " }\n";
  }
  file.close();
  std::vector<std::string> warnings;
  const Scene scene = read_scene_text(
      "light sodium 0 1 0 1 light blackbody(3000) 0 1 0 1 background line(500)", folder / "s.sdl",
      [&](const std::string& message) { warnings.push_back(message); });
  CHECK(scene.lights.at(0).spectrum.at(400.0) == 0.25);
  CHECK(scene.lights.at(1).spectrum.at(400.0) == 0.25);
  REQUIRE(warnings.size() == 2);
  CHECK(warnings[0].find("\"sodium\" is the light of ") != std::string::npos);
  CHECK(warnings[1].find("which hides the built-in light of this name") != std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_CASE("errors of lamps") {
  CHECK(scene_error("background blackbody(10)") ==
        "s.sdl:1:12: 10 is out of range for blackbody (it is a temperature in kelvin). Give a "
        "number from 500 to 1000000");
  CHECK(scene_error("background daylight(3000)") ==
        "s.sdl:1:12: 3000 is out of range for daylight (it is a correlated colour temperature in "
        "kelvin). Give a number from 4000 to 25000");
  CHECK(scene_error("background line(900)") ==
        "s.sdl:1:12: 900 is out of range for line (it is a wavelength in nm). Give a number from "
        "380 to 780");
  CHECK(scene_error("background line(red)") ==
        "s.sdl:1:12: \"red\" is not a number (line takes a wavelength in nm). Write it without "
        "spaces, such as line(632.8)");
  CHECK(scene_error("background line( 600 )") ==
        "s.sdl:1:12: \")\" is missing in \"line(\" (line takes a wavelength in nm). Write it "
        "without spaces, such as line(632.8)");
  CHECK(scene_error("background sodum").find("Did you mean sodium?") != std::string::npos);
}
