#include "core/planning/make_plan.h"
#include "core/planning/plan_tiles.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>

using namespace abbe;

namespace {

std::size_t empty_tiles(const Plan& plan) {
  return static_cast<std::size_t>(
      std::count_if(plan.tiles.begin(), plan.tiles.end(), [](const Tile& t) { return t.empty; }));
}

Plan plan_of(const std::string& text) {
  const Scene scene = test::scene_from(text);
  return make_plan(scene, scene.settings);
}

} // namespace

TEST_CASE("tiles cover the window once, and the last ones are cut") {
  const Plan plan = plan_of("imageSize 100 50 crop 3 5 100 41 sphere");
  std::size_t pixels = 0;
  for (const Tile& tile : plan.tiles) {
    pixels += tile.window.pixel_count();
    CHECK(tile.window.x0 >= 3);
    CHECK(tile.window.y0 >= 5);
    CHECK(tile.window.x1 <= 100);
    CHECK(tile.window.y1 <= 41);
  }
  CHECK(pixels == plan.window.pixel_count());
}

TEST_CASE("tiles far from every shape are empty") {
  // 30 degrees at distance 5 show 2.68 units; a ball of radius 0.1 covers 39 of 512 pixels.
  const Plan plan = plan_of("imageSize 512 512 background E 1 scale 0.1 0.1 0.1 sphere");
  CHECK(empty_tiles(plan) == plan.tiles.size() - 16); // those around the middle
  CHECK(empty_tiles(plan_of("imageSize 512 512 background E 1")) == plan.tiles.size());
}

TEST_CASE("a shape that fills the picture or surrounds the eye leaves no tile empty") {
  CHECK(empty_tiles(plan_of("imageSize 64 64 scale 9 9 1 square")) == 0);
  CHECK(empty_tiles(plan_of("imageSize 64 64 scale 9 9 9 sphere")) == 0);
  CHECK(empty_tiles(plan_of("imageSize 64 64 translate 0 -1 0 rotate 90 1 0 0 plane")) == 0);
  // The square passes beside the eye; its box is partly behind it.
  CHECK(empty_tiles(
            plan_of("imageSize 64 64 translate 3 0 5 rotate 90 0 1 0 scale 9 9 9 square")) == 0);
}

TEST_CASE("a shape behind the eye leaves every tile empty, or it does no harm") {
  const Plan plan = plan_of("imageSize 64 64 background E 1 translate 0 0 50 sphere");
  // Its corners cannot be projected, so the tiles count as covered: slow, never wrong.
  CHECK(empty_tiles(plan) == 0);
}

TEST_CASE("without skipping no tile is taken for empty") {
  CHECK(empty_tiles(plan_of("imageSize 64 64")) == 16);
  const Scene scene = test::scene_from("imageSize 64 64");
  RenderSettings settings = scene.settings;
  settings.skip = false;
  CHECK(empty_tiles(make_plan(scene, settings)) == 0);
}

TEST_CASE("no ray of an empty tile meets a shape, with any filter") {
  for (const char* filter : {"box", "tent", "gaussian"})
    for (const char* shape :
         {"scale 0.1 0.1 0.1 sphere", "translate 0.7 0.4 1 rotate 30 1 1 0 scale 0.2 0.05 0.4 cube",
          "translate -0.5 0 3 rotate 80 0 1 0 square",
          "translate 1.2 1.2 0 scale 0.3 0.3 0.3 prism",
          "translate 0 0.6 0 scale 0.2 0.3 0.1 lens translate 0.5 0 0 sphere translate -1 0 0 "
          "sphere"}) {
      const std::string text =
          std::string("imageSize 100 100 samples 16 background E 1 filter ") + filter + " " + shape;
      CAPTURE(text);
      Scene scene = test::scene_from(text);
      const Plan plan = make_plan(scene, scene.settings);
      REQUIRE(empty_tiles(plan) > 0);
      REQUIRE(empty_tiles(plan) < plan.tiles.size());
      scene.settings.skip = false;
      const Rendering all = test::render_scene(scene, false);
      double covered = 0.0;
      for (const Tile& tile : plan.tiles)
        if (tile.empty)
          for (int y = tile.window.y0; y < tile.window.y1; ++y)
            for (int x = tile.window.x0; x < tile.window.x1; ++x)
              covered += all.film.covered_samples(x, y);
      CHECK(covered == 0.0);
    }
}

TEST_CASE("through a lens no tile is taken for empty") {
  const std::string text = "imageSize 64 64 background E 1 scale 0.1 0.1 0.1 sphere ";
  CHECK(empty_tiles(plan_of(text)) > 0);
  CHECK(empty_tiles(plan_of(text + "aperture 0.1")) == 0);
  CHECK(empty_tiles(plan_of(text + "unit m lensFile \"" ABBE_SOURCE_DIR
                                   "/scenes/lenses/cooke_triplet.lens\"")) == 0);
}
