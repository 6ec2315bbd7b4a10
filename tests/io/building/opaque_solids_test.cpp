#include "io/building/opaque_solids.h"

#include "io/scene_language/read_scene.h"
#include "tests/catch.h"

#include <string>
#include <vector>

using namespace abbe;

namespace {

std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<std::string> warnings;
  (void)read_scene_text(text, "s.sdl",
                        [&](const std::string& message) { warnings.push_back(message); });
  return warnings;
}

const std::string kEyeOutside = "eye 0 0 9 lookAt 0 0 0\n";
const std::string kEyeInside = "eye 0 0 0.5 lookAt 0 0 0\n";
const std::string kLightInside = "light 0.1 0.2 0.3 1 1 1\n";
const std::string kLightOutside = "light 5 5 5 1 1 1\n";

} // namespace

TEST_CASE("an opaque solid between the camera and a light is warned of at its line") {
  using Warnings = std::vector<std::string>;
  const std::string unseen = ": nothing of that light is seen";
  CHECK(warnings_of(kEyeOutside + kLightInside + "cube") ==
        Warnings{"s.sdl:3:1: 1 light is inside of this opaque solid, and the camera is not" +
                 unseen});
  CHECK(warnings_of(kEyeInside + kLightOutside + kLightOutside + kLightInside + "cube") ==
        Warnings{"s.sdl:5:1: the camera is inside of this opaque solid, and 2 lights are outside" +
                 unseen});
  CHECK(warnings_of(kEyeInside + "background 1 1 1\ncube") ==
        Warnings{"s.sdl:3:1: the camera is inside of this opaque solid, and only the sky gives "
                 "light"});
  // The shape that is defined last stands in the line of its own keyword.
  CHECK(warnings_of(kEyeOutside + kLightInside + "push translate 9 9 9 sphere pop\nsphere")
            .at(0)
            .starts_with("s.sdl:4:1: "));
}

TEST_CASE("what light can leave, and a room with its lamps, is not warned of") {
  for (const std::string& text : {
           kEyeOutside + kLightOutside + "cube",                       // both outside
           kEyeInside + kLightInside + "cube",                         // a room
           kEyeOutside + kLightInside + "glass N-BK7 cube",            // glass
           kEyeOutside + kLightInside + "push scale 3 3 1 square pop", // no inside
           kEyeOutside + "light 1 0 0 1 1 1\ncube",                    // a lamp on a face
           kEyeInside + "emissive 1 1 1 cube",                         // the walls give light
           kEyeInside + "background 1 1 1\nglobalAmbient 1 1 1 cube",
           // A glass rod of higher priority leads out of the opaque cube.
           kEyeOutside + kLightInside + "cube glass N-BK7 priority 1 push scale 0.5 0.5 3 cube pop",
       }) {
    INFO(text);
    CHECK(warnings_of(text).empty());
  }
}

TEST_CASE("many lights and many solids are compared in less than quadratic time") {
  std::string text = kEyeOutside;
  for (int i = 0; i < 20'000; ++i) {
    const std::string x = std::to_string(3 * i);
    text += "push translate " + x + " 20 0 sphere pop light " + x + " 22 0 1 1 1\n";
  }
  CHECK(warnings_of(text).empty());
}
