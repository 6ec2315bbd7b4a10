#include "tests/io/scene_language/read_scene_helpers.h"

#include "tests/catch.h"

using namespace abbe;

TEST_CASE("how light paths are followed") {
  const RenderSettings usual = scene_of("").settings;
  CHECK(usual.caustics == Caustics::automatic);
  CHECK(usual.light_paths == 1.0);
  CHECK(usual.photon_radius == 0.0);
  const RenderSettings s = scene_of("caustics on lightPaths 0.5 photonRadius 0.2").settings;
  CHECK(s.caustics == Caustics::on);
  CHECK(s.light_paths == 0.5);
  CHECK(s.photon_radius == 0.2);
  CHECK(scene_of("caustics off").settings.caustics == Caustics::off);
}

TEST_CASE("errors of light paths") {
  CHECK(
      scene_error("caustics maybe") ==
      "s.sdl:1:10: \"maybe\" is no choice of caustics (caustics takes on|off|automatic). Give on, "
      "off or automatic");
  CHECK(scene_error("lightPaths 0") ==
        "s.sdl:1:12: 0 is out of range for lightPaths (it is a number of light paths per camera "
        "sample). Give a number more than 0 and less than 1000000");
  CHECK(
      scene_error("photonRadius -1") ==
      "s.sdl:1:14: -1 is out of range for photonRadius (it is a length). Give a number 0 or more");
}
