#include "io/outputs/picture_warnings.h"

#include "core/image/develop.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <string>
#include <utility>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string kSmall = "imageSize 4 4 samples 2 bands 9 ";
const std::string kCard = "defaultMaterials ambient 0 0 0 diffuse 0.5 0.5 0.5 square ";

std::string darkness(const std::string& text) {
  const Scene scene = test::scene_from(kSmall + text);
  return warning_of_darkness(scene, make_plan(scene, scene.settings),
                             test::render_scene(scene, false));
}

std::string exposure(const std::string& text, double stops) {
  const Scene scene = test::scene_from(kSmall + text);
  DisplaySettings display;
  display.exposure_ev = stops;
  const Film film = std::move(test::render_scene(scene, false).film);
  return warning_of_exposure(film,
                             develop_display(film, make_plan(scene, scene.settings), display));
}

} // namespace

TEST_CASE("a black picture is told, with its cause") {
  CHECK_THAT(darkness(kCard), ContainsSubstring("nothing in the scene gives light"));
  CHECK_THAT(darkness("light E 0 0 1 0 push translate 0 0 50 " + kCard + "pop"),
             ContainsSubstring("no ray of the camera meets a shape"));
  // A lamp behind the card, and a lamp in an opaque box.
  CHECK_THAT(darkness("light E 0 0 -1 0 " + kCard), ContainsSubstring("no light reaches"));
  CHECK_THAT(
      darkness("light E 3 0 1 1 " + kCard + "push translate 3 0 1 scale 0.1 0.1 0.1 cube pop"),
      ContainsSubstring("no light reaches"));
}

TEST_CASE("a camera's lens that lets no ray through is told") {
  const std::string text = "light E 0 0 1 0 " + kCard;
  Scene scene = test::scene_from(kSmall + text);
  Rendering rendering = test::render_scene(scene, false);
  const Plan plan = make_plan(scene, scene.settings);
  CHECK(warning_of_darkness(scene, plan, rendering).empty());
  scene.camera.kind = RealLens{};
  Film empty(rendering.film.window(), 1.0, 0);
  rendering.film = std::move(empty);
  CHECK_THAT(warning_of_darkness(scene, plan, rendering),
             ContainsSubstring("no light reaches") || ContainsSubstring("meets a shape"));
  rendering.rays.camera = 0;
  CHECK_THAT(warning_of_darkness(scene, plan, rendering),
             ContainsSubstring("no ray gets through the camera's lens"));
}

TEST_CASE("a picture that is not black has no such warning, nor one that a plate shows through") {
  CHECK(darkness("light E 0 0 1 0 " + kCard).empty());
  CHECK(darkness("background E 1").empty());
  CHECK(darkness("background E 1 sky transparent").empty());
}

TEST_CASE("an exposure that leaves nothing to see is told") {
  const std::string lit = "light E 0 0 1 0 " + kCard;
  const std::string sky = "background E 1 ";
  CHECK(exposure(sky, 0.0).empty());   // white, and meant so
  CHECK(exposure(kCard, 0.0).empty()); // black by itself
  CHECK(exposure(sky + lit, 0.0).empty());
  CHECK_THAT(exposure(sky + lit, 9.0), ContainsSubstring("exposure is too high"));
  CHECK_THAT(exposure(sky + lit, -20.0), ContainsSubstring("exposure is too low"));
}
