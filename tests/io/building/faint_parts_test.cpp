#include "io/building/faint_parts.h"

#include "io/scene_language/read_scene.h"
#include "tests/catch.h"

#include <string>
#include <vector>

using namespace abbe;

namespace {

std::vector<std::string> warnings_of(const std::string& text,
                                     const SettingsOverride& options = {}) {
  std::vector<std::string> warnings;
  GivenKeywords given;
  const Scene scene = read_scene_text(text, "s.sdl", nullptr, nullptr, &given);
  warn_of_faint_parts(scene, given, options,
                      [&](const std::string& message) { warnings.push_back(message); });
  return warnings;
}

} // namespace

TEST_CASE("settings that leave out parts of materials are warned of at their line") {
  using Warnings = std::vector<std::string>;
  const std::string mirrors = "reflectivity 0.05 sphere reflectivity 0.02 sphere\n";
  CHECK(warnings_of(mirrors).empty());
  CHECK(warnings_of(mirrors + "minReflectivity 0.01").empty());
  CHECK(warnings_of("sphere minReflectivity 0.5").empty()); // nothing is reflected
  CHECK(warnings_of(mirrors + "minReflectivity 0.03") ==
        Warnings{"s.sdl:2:1: minReflectivity 0.03 takes light from the picture: 1 of its materials "
                 "reflect at most 0.02, and their reflections are left out"});
  CHECK(warnings_of("fresnel off transparency 0.1 cube\n minTransparency 0.2") ==
        Warnings{"s.sdl:2:2: minTransparency 0.2 takes light from the picture: 1 of its materials "
                 "let through at most 0.1, and their refractions are left out"});
  CHECK(warnings_of(mirrors, {{&setting_of_option("--min-reflectivity"), "0.5"}}) ==
        Warnings{"--min-reflectivity 0.5 takes light from the picture: 2 of its materials reflect "
                 "at most 0.05, and their reflections are left out"});
}
