#include "core/render/memory_need.h"

#include "tests/catch.h"
#include "tests/render_text.h"

#include <string>

using namespace abbe;

namespace {

/// Bytes per pixel of a square picture of 512 pixels, without its tiles.
double per_pixel(const std::string& text, const std::optional<BandPlace>& bands = {}) {
  Scene scene = read_scene_text("imageSize 512 512 " + text, "test.sdl", {});
  const Plan plan = make_plan(scene, scene.settings);
  const auto tiles = static_cast<double>(plan.tiles.size() * (sizeof(Tile) + sizeof(PixelWindow)));
  return (static_cast<double>(memory_need(scene, plan, bands)) - tiles) / (512.0 * 512.0);
}

} // namespace

// The film: three sums of 8 bytes and two counts of 4. The picture for screens: six floats.
TEST_CASE("memory is what the film's layers and the largest picture of them take") {
  const std::string sky = "background E 1 samples 1 ";
  constexpr double film = 3 * 8 + 2 * 4, picture = 6 * 4;
  CHECK(per_pixel(sky) == film + picture);
  CHECK(per_pixel("samples 1") == film + picture + 8); // alpha
  // Adaptive sampling: as many sums again and two counts; rays, shares and numbers; what finds the
  // shares after the first round.
  CHECK(per_pixel("background E 1 samples 16") == film + picture + 3 * 8 + 8 + 12 + 32);
  CHECK(per_pixel(sky + "bands 27 ", BandPlace{}) == film + picture + 27 * 8);
  // In a file, as far as it is kept in memory: 27 * 8 * 2^18 bytes are less than 256 MiB.
  CHECK(per_pixel(sky + "bands 27 ", BandPlace{"/tmp", 1}) == film + picture + 27 * 8);
  CHECK(per_pixel(sky + "bands 405 ", BandPlace{"/tmp", 1}) == film + picture + 1024);
}

TEST_CASE("the sums in files are told") {
  Scene scene = read_scene_text("imageSize 512 512 samples 1 bands 27", "test.sdl", {});
  const Plan plan = make_plan(scene, scene.settings);
  CHECK(disk_need(scene, plan, BandPlace{"/tmp", 1}) == 512ULL * 512 * 27 * 8);
  CHECK(disk_need(scene, plan, BandPlace{"/tmp"}) == 0);
  CHECK(disk_need(scene, plan, BandPlace{"/tmp", 1, false}) == 0);
}

// A table of a glass holds its index every 1/16 nm from 377.5 to 782.5 nm, both ends too.
TEST_CASE("what a plan's tables take is told before they are made") {
  const auto need = [](const std::string& text) {
    const Scene scene = read_scene_text(text, "test.sdl", {});
    return least_plan_need(scene, scene.settings);
  };
  constexpr std::uint64_t table = (16 * 405 + 1) * 8;
  const std::uint64_t one = need("abbe 1.5 60 sphere"), two = need("abbe 1.5 60 sphere "
                                                                   "abbe 1.5 61 sphere");
  CHECK(two - one == table + sizeof(MediumPlan)); // the material is the same
  CHECK(one - need("speedOfLight 1.5 transparency 1 reflectivity 1 sphere") == table - 8);
  const std::string matt = "defaultMaterials diffuse 0.5 0.5 0.5 ";
  CHECK(need(matt + "coat N-BK7 sphere") - need(matt + "sphere") == table);
  CHECK(need("abbe 1.5 60 thinFilm 100 N-BK7 sphere") - one == table);
}

TEST_CASE("settings alone tell no more memory than the plan does") {
  for (const std::string text : {"samples 1 background E 1", "samples 64", "crop 0 0 100 3"}) {
    Scene scene = read_scene_text("imageSize 300 200 " + text, "test.sdl", {});
    const Plan plan = make_plan(scene, scene.settings);
    CHECK(least_memory_need(scene.settings) <= memory_need(scene, plan, {}));
    CHECK(least_memory_need(scene.settings) >= plan.window.pixel_count() * 56);
  }
}
