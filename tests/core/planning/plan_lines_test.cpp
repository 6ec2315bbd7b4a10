#include "core/planning/make_plan.h"
#include "core/planning/plan_lines.h"

#include "core/bundles/path_wavelengths.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

using namespace abbe;

TEST_CASE("a band whose light is all from lines is traced at the lines") {
  const Scene scene = test::scene_from("light sodium 0 0 5 1 light line(632.8) 0 0 5 1\n"
                                       "glass N-SF11 sphere");
  const Plan plan = make_plan(scene, scene.settings);
  const int d = plan.grid.band_of(589.0), laser = plan.grid.band_of(632.8);
  REQUIRE(plan.lines.size() == 81);
  CHECK(plan.wavelength_nm(d, 0.1) == 588.995); // two thirds of the power
  CHECK(plan.wavelength_nm(d, 0.66) == 588.995);
  CHECK(plan.wavelength_nm(d, 0.67) == 589.5924);
  CHECK(plan.wavelength_nm(laser, 0.0) == 632.8);
  CHECK(plan.wavelength_nm(laser, 1.0) == 632.8);
  CHECK(plan.wavelength_nm(0, 0.5) == 380.0);
  CHECK(plan.live_first == d);
  CHECK(plan.live_last == laser + 1);
  CHECK(plan.live_count == 2);

  PathWavelengths path(plan);
  path.begin_path(0.9);
  CHECK(path.indices(MediumId{0})[laser] ==
        Approx(refractive_index(find_glass("N-SF11")->dispersion, 632.8)).margin(1e-7));
}

TEST_CASE("a line beside a continuous spectrum shares the band's wavelengths") {
  const Scene scene =
      test::scene_from("light line(632.8) 0 0 5 1 background D65 0.1 glass N-BK7 sphere");
  const Plan plan = make_plan(scene, scene.settings);
  CHECK(plan.lines.empty());
  const int laser = plan.grid.band_of(632.8);
  CHECK(plan.wavelength_nm(laser, 0.25) == plan.grid.wavelength_nm(laser, 0.25));
  CHECK(make_plan(test::scene_from("light D65 0 0 5 1 sphere"), scene.settings).lines.empty());
}

TEST_CASE("the colour of a line does not depend on the number of bands") {
  // A white square in the light of a laser: its colour is the observer's at the line.
  const auto color = [](const std::string& bands) {
    const Scene scene = test::scene_from(
        "fieldOfView 0.0001 imageSize 1 1 samples 1 eye 3 0 4 lookAt 0 0 0 bands " + bands +
        " ambient 0 0 0 diffuse 1 1 1 light line(632.8) 0 0 5 1 square");
    const Rendering r = test::render_scene(scene, false);
    return r.film.color(0, 0);
  };
  const Xyz expected = color("81");
  CHECK(expected.y == Approx(1.0).epsilon(1e-5));
  for (const char* bands : {"1", "3", "9", "27", "60", "200", "405"}) {
    INFO(bands);
    const Xyz c = color(bands);
    CHECK(c.x == Approx(expected.x).epsilon(1e-5));
    CHECK(c.y == Approx(expected.y).epsilon(1e-5));
    CHECK(c.z == Approx(expected.z).margin(1e-6));
  }
}

// A lossless ball is invisible in even light. Had the dark bands between two lines a share of its
// rays, a line would be followed by chance only, and the ball would be noise.
TEST_CASE("dark bands between two lines take no rays from them") {
  for (const char* skip : {"on", "off"}) {
    Scene scene = test::scene_from("imageSize 16 16 samples 4 fieldOfView 25 minThroughput 0\n"
                                   "background line(450) light line(632.8) 0 9 0 1\n"
                                   "glass N-SF11 sphere");
    scene.settings.skip = std::string(skip) == "on";
    const Film film = std::move(test::render_scene(scene, false).film);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        CHECK(film.color(x, y).y == Approx(1.0).epsilon(0.02));
  }
}
