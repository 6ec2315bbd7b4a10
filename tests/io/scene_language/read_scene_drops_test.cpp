#include "core/drops/drop_phase_function.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

#include <numbers>

using namespace abbe;

namespace {

Drops drops_of(const std::string& text) {
  return scene_of(text).media.at(0).drops.value();
}

} // namespace

TEST_CASE("drops fill a solid that is not seen itself") {
  const Scene scene = scene_of("reflectivity 0.5 drops 2e-6 sphere");
  const Medium& medium = scene.media.at(0);
  REQUIRE(medium.drops);
  CHECK(medium.drops->extinction_per_mm == 2e-6);
  CHECK(medium.drops->index == water_in_air());
  CHECK(medium.drops->sun_radius == Approx(0.2665 * std::numbers::pi / 180.0));
  CHECK(refractive_index(medium.index, 500.0) == 1.0);
  const Material& finish = scene.materials.at(0);
  CHECK(finish.transparency.constant_value() == 1.0);
  CHECK(finish.reflectivity.constant_value() == 0.0);
  CHECK(finish.diffuse.constant_value() == 0.0);
  CHECK(finish.ambient.constant_value() == 0.0);
}

TEST_CASE("drops are of a number, of water or of a glass, under a sun of any size") {
  CHECK(drops_of("drops 1 dropIndex 1.3311 cube").index == Dispersion(ConstantIndex{1.3311}));
  CHECK(drops_of("drops 1 dropIndex 1.5 dropIndex WATER cube").index == water_in_air());
  CHECK(drops_of("drops 1 dropIndex n-bk7 cube").index == find_glass("N-BK7")->dispersion);
  CHECK(drops_of("drops 1 dropSun 0 cube").sun_radius == 0.0);
  CHECK(drops_of("drops 1 dropSun 45 cube").sun_radius == Approx(std::numbers::pi / 4.0));
}

TEST_CASE("drops begin anew at each drops, and end at the next material") {
  CHECK(drops_of("drops 1 dropIndex 1.5 dropSun 3 drops 2 cube") == drops_of("drops 2 cube"));
  CHECK_FALSE(scene_of("drops 1 glass N-BK7 cube").media.at(0).drops);
  CHECK(scene_of("drops 1 defaultMaterials cube").media.empty());
  CHECK(scene_of("drops 1 cube drops 2 cube drops 1 cube").media.size() == 2);
}

TEST_CASE("drops fill booleans") {
  const Scene scene = scene_of("drops 1 difference cube sphere");
  CHECK(scene.shapes.size() == 1);
  CHECK(scene.media.at(0).drops);
}

TEST_CASE("errors of drops") {
  CHECK(scene_error("drops 0") == "s.sdl:1:7: 0 is out of range for drops (it is an extinction per "
                                  "mm). Give a number more than 0 and less than 1000000000");
  CHECK(scene_error("drops 1 dropIndex 0.9") ==
        "s.sdl:1:19: 0.9 is out of range for dropIndex (it is the index of a drop in air). Give a "
        "number from 1 to 10");
  CHECK(scene_error("drops 1 dropIndex N-BK77")
            .starts_with(
                "s.sdl:1:19: unknown glass \"N-BK77\" (no such name in the glass catalogue)"));
  CHECK(scene_error("drops 1 dropSun 46") ==
        "s.sdl:1:17: 46 is out of range for dropSun (it is the radius of the sun's disc in "
        "degrees). Give a number from 0 to 45");
  CHECK(scene_error("glass N-BK7 dropSun 1") ==
        "s.sdl:1:13: dropSun without drops (no drops fill the solids that follow). Give drops "
        "before it");
  CHECK(scene_error("dropIndex 1.3") ==
        "s.sdl:1:1: dropIndex without drops (no drops fill the solids that follow). Give drops "
        "before it");
  CHECK(scene_error("drops 1 speedOfLight 1.3 cube") ==
        "s.sdl:1:26: drops hang in something with an index other than 1 (they are known in air "
        "only). Remove speedOfLight and vnum behind drops");
}
