#include "io/building/setting_effects.h"

#include "io/scene_language/read_scene.h"
#include "tests/catch.h"

#include <filesystem>
#include <string>
#include <vector>

using namespace abbe;

namespace {

std::vector<std::string> warnings_of(const std::string& text,
                                     const SettingsOverride& options = {}) {
  std::vector<std::string> warnings;
  const Warn warn = [&](const std::string& message) { warnings.push_back(message); };
  GivenKeywords given;
  const Scene scene = read_scene_text(text, "s.sdl", warn, nullptr, &given);
  warn_of_settings(scene, given, options, warn);
  return warnings;
}

SettingsOverride option(const std::string& name, const std::string& text) {
  return {{&setting_of_option(name), text}};
}

} // namespace

TEST_CASE("settings that have no effect beside the others are warned of at their line") {
  const std::string light_paths =
      "light paths are followed by the integrator path only, and unless caustics is off";
  const std::string exact = "with exact, no two bands share a ray";
  const std::vector<std::vector<std::string>> cases{
      // the keyword, what lets it act, what does not, and why
      {"caustics on", "integrator path", "integrator whitted",
       "light paths are followed by the integrator path only"},
      {"lightPaths 2", "integrator path", "", light_paths},
      {"lightPaths 2", "integrator path", "integrator path caustics off", light_paths},
      {"photonRadius 2", "integrator path", "", light_paths},
      {"brightSky 2",
       "integrator path environment \"" ABBE_SOURCE_DIR "/tests/fuzz/corpus/files/sky.exr\"",
       "integrator path",
       "it says which light of an environment is followed by light paths, with the integrator "
       "path"},
      {"tolerance 2", "", "exact on", exact},
      {"maxFan 2", "", "exact on", exact},
      {"globalAmbient 1 1 1", "", "integrator path", "the integrator path takes no ambient light"},
      {"focusDistance 9", "aperture 1", "",
       "the camera is a pinhole, through which all is sharp: it needs an aperture or fNumber"},
      {"focusDistance 900", "focalLength 50 filmHeight 24", "aperture 0",
       "the camera is a pinhole, through which all is sharp: it needs an aperture or fNumber"},
      {"fieldOfView 20", "", "focalLength 2 filmHeight 24", "filmHeight replaces it"},
  };
  for (const auto& row : cases) {
    INFO(row[0] << " / " << row[2]);
    CHECK(warnings_of(row[1] + "\n" + row[0]).empty());
    CHECK(warnings_of(row[2] + "\n" + row[0]) ==
          std::vector<std::string>{"s.sdl:2:1: " + row[0].substr(0, row[0].find(' ')) +
                                   " has no effect (" + row[3] + ")"});
  }
}

TEST_CASE("options of the command line are asked too, and a scene is not blamed for them") {
  CHECK(warnings_of("sphere", option("--light-paths", "2")) ==
        std::vector<std::string>{"--light-paths has no effect (light paths are followed by the "
                                 "integrator path only, and unless caustics is off)"});
  CHECK(warnings_of("integrator path", option("--light-paths", "2")).empty());
  CHECK(warnings_of("lightPaths 2", option("--integrator", "path")).empty());
  CHECK(warnings_of("integrator path lightPaths 2", option("--integrator", "whitted")).empty());
  CHECK(warnings_of("exact on", option("--fan", "2")).size() == 1);
}

TEST_CASE("caustics of a light without flux are refused at the light") {
  GivenKeywords given;
  const Scene scene = read_scene_text(
      "integrator path caustics on light E 0 0 1 0\nlight 0 5 5 1 1 1 light 1 5 5 1 1 1", "s.sdl",
      {}, nullptr, &given);
  CHECK_THROWS_WITH(
      check_caustics(given, scene.settings),
      "s.sdl:2:1: this light has no flux that could be followed for caustics (it does "
      "not fall off with distance, and caustics is on). Give it falloff square, or "
      "leave caustics on out");
  CHECK_NOTHROW(check_caustics(given, overridden(scene.settings, option("--caustics", "off"))));
  CHECK_NOTHROW(
      check_caustics(given, overridden(scene.settings, option("--integrator", "whitted"))));
  given.clear();
  const Scene square = read_scene_text(
      "integrator path caustics on falloff square light 0 5 5 1 1 1", "s.sdl", {}, nullptr, &given);
  CHECK_NOTHROW(check_caustics(given, square.settings));
}

TEST_CASE("no scene of the project has a keyword without effect") {
  int count = 0;
  for (const std::string folder : {"scenes", "bench/scenes"})
    for (const auto& file :
         std::filesystem::directory_iterator(std::string(ABBE_SOURCE_DIR "/") + folder)) {
      if (file.path().extension() != ".sdl") continue;
      INFO(file.path());
      GivenKeywords given;
      const Warn warn = [](const std::string& message) {
        CHECK(message.find("no effect") == std::string::npos);
      };
      const Scene scene = read_scene(file.path(), warn, nullptr, &given);
      warn_of_settings(scene, given, {}, warn);
      ++count;
    }
  CHECK(count > 30);
}
