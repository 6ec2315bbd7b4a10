#include "core/plan/plan.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_bands.h"
#include "core/planning/plan_extent.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>
#include <cmath>

using namespace abbe;

namespace {

const std::string kLibrary = "lights \"" ABBE_SOURCE_DIR "/scenes/lights.filter\"\n";

Plan plan_of(const std::string& text) {
  const Scene scene = test::scene_from(kLibrary + text);
  return make_plan(scene, scene.settings);
}

bool refracts(const Plan& plan) {
  return std::any_of(plan.materials.begin(), plan.materials.end(),
                     [](const MaterialPlan& m) { return m.facts().transmits; });
}

} // namespace

// The thesis's filter 2a is 0 up to 405 nm and from 705 nm on.
TEST_CASE("under filter 2a only the bands from 410 to 700 nm live") {
  const Plan plan = plan_of("light 2a 0 5 0 1 square");
  CHECK(plan.grid.center_nm(plan.first_band) == 410.0);
  CHECK(plan.grid.center_nm(plan.last_band - 1) == 700.0);
  CHECK(plan.live_count == 59); // 410, 415, ... 700 nm
}

TEST_CASE("other light brings its bands back") {
  for (const char* more : {"background E 0.1", "globalAmbient E 0.1", "light E 1 1 1 1",
                           "defaultMaterials emissive 1 1 1 square"}) {
    const Plan plan = plan_of(std::string("light 2a 0 5 0 1 square ") + more);
    CHECK(plan.first_band == 0);
    CHECK(plan.last_band == 81);
    CHECK(plan.live_count == 81);
  }
}

TEST_CASE("bands without light are carried when nothing is to be skipped, and still known") {
  const Scene scene = test::scene_from(kLibrary + "light 2a 0 5 0 1 square");
  RenderSettings settings = scene.settings;
  settings.skip = false;
  const Plan plan = make_plan(scene, settings);
  CHECK(plan.first_band == 0);
  CHECK(plan.last_band == 81);
  CHECK(plan.grid.center_nm(plan.live_first) == 410.0);
  CHECK(plan.grid.center_nm(plan.live_last - 1) == 700.0);
  CHECK(plan.live_count == 59);
}

TEST_CASE("a scene without light is planned as black") {
  const Plan plan = plan_of("square");
  CHECK(nothing_gives_light(plan));
  CHECK(std::ranges::count(plan.notes, "nothing gives light: the picture is black") == 1);
  CHECK(plan.live_count == 81); // alpha is there without light
  const Rendering r =
      test::render_scene(test::scene_from("imageSize 4 4 square glass SF11 sphere"), true);
  CHECK(r.film.color(2, 2) == Xyz{0.0, 0.0, 0.0});
  CHECK(r.film.refused().not_finite == 0);
}

TEST_CASE("the plan knows which media a scene has, and whether it refracts or disperses") {
  const Plan none = plan_of("light E 0 5 0 1 sphere square");
  CHECK(none.media.empty());
  CHECK_FALSE(refracts(none));
  CHECK_FALSE(none.disperses);
  const Plan plain = plan_of("defaultMaterials transparency 1 speedOfLight 1.5 sphere");
  REQUIRE(plain.media.size() == 1);
  CHECK(plain.media[0].index.achromatic());
  CHECK(refracts(plain));
  CHECK_FALSE(plain.disperses);
  const Plan glass = plan_of("light E 0 5 0 1 glass SF11 sphere");
  REQUIRE(glass.media.size() == 1);
  CHECK_FALSE(glass.media[0].index.achromatic());
  CHECK(refracts(glass));
  CHECK(glass.disperses);
}

TEST_CASE("a crop must be a part of the image that holds a pixel") {
  const Scene scene = test::scene_from("imageSize 64 48 sphere");
  const auto window = [&](PixelWindow crop) {
    RenderSettings settings = scene.settings;
    settings.crop = crop;
    return make_plan(scene, settings).window;
  };
  CHECK(make_plan(scene, scene.settings).window == PixelWindow{0, 0, 64, 48});
  CHECK(window({63, 47, 64, 48}) == PixelWindow{63, 47, 64, 48});
  constexpr int kMost = 2147483647;
  for (const PixelWindow& wrong :
       {PixelWindow{0, 0, 65, 48}, PixelWindow{0, 0, 64, 49}, PixelWindow{-1, 0, 8, 8},
        PixelWindow{0, -1, 8, 8}, PixelWindow{8, 8, 8, 9}, PixelWindow{8, 8, 9, 8},
        PixelWindow{9, 8, 8, 9}, PixelWindow{-kMost - 1, 0, kMost, 1}}) {
    CAPTURE(wrong.x0, wrong.y0, wrong.x1, wrong.y1);
    CHECK_THROWS_WITH(window(wrong),
                      Catch::Matchers::ContainsSubstring("not a part of the 64 x 48 image"));
  }
}

TEST_CASE("at 81 bands all sources share one accumulator, at 27 each spectrum has its own") {
  const std::string lamps = "background D65 0.1 light E 0 5 0 1 light 2a 0 6 0 1 light E 1 5 0 1 "
                            "light FL11 2 5 0 1 square";
  for (const int bands : {81, 405}) {
    const Plan plan = plan_of(lamps + " bands " + std::to_string(bands));
    CHECK(plan.accumulators.size() == 1);
    for (const SourcePlan& source : plan.sources)
      CHECK(source.accumulator == 0);
  }
  const Plan plan = plan_of(lamps + " bands 27");
  // background, ambient light (the constant 0), E, 2a, FL11; the second E joins the first
  CHECK(plan.accumulators.size() == 5);
  const auto of_lamp = [&](std::size_t i) {
    return plan.sources[static_cast<std::size_t>(plan.light_source(i))].accumulator;
  };
  CHECK(of_lamp(0) == of_lamp(2));
  CHECK(of_lamp(0) != of_lamp(1));
  CHECK(of_lamp(1) != of_lamp(3));
}

TEST_CASE("materials are tabulated at the bands' centres, with what can be left out") {
  const Scene scene = test::scene_from("background E 1 defaultMaterials diffuse 0.9 0.4 0.1 "
                                       "specular 0.2 0.2 0.2 specularExponent 12 cube "
                                       "defaultMaterials reflectivity 0.4 cube "
                                       "glass SF11 cube");
  const Plan plan = make_plan(scene, scene.settings);
  REQUIRE(plan.materials.size() == 3);
  const MaterialPlan &dull = plan.materials[0], &mirror = plan.materials[1],
                     &glass = plan.materials[2];
  for (int b = 0; b < 81; ++b)
    CHECK(dull.diffuse[b] == static_cast<float>(scene.materials[0].diffuse.at(380.0 + 5.0 * b)));
  CHECK(dull.phong.exponent == 12.0f);
  CHECK((dull.lit() && std::holds_alternative<Diffuse>(dull.bsdf)));
  CHECK((mirror.lit() && std::holds_alternative<Mirror>(mirror.bsdf)));
  CHECK((!glass.lit() && std::holds_alternative<Dielectric>(glass.bsdf)));
  CHECK(glass.emission_source < 0);
  CHECK(glass.ambient.zero());
}

TEST_CASE("absorption is counted per unit of the scene") {
  const Plan plan = plan_of("unit cm background E 1 "
                            "defaultMaterials transparency 1 speedOfLight 1.5 absorption 0.3 cube");
  REQUIRE(plan.media.size() == 1);
  CHECK(plan.media[0].absorbs);
  CHECK(plan.media[0].absorption_per_unit[40] == Approx(3.0));
  CHECK_FALSE(plan.medium(MediumId{}).absorbs);
}

TEST_CASE("the film's quantum is a power of two and follows the brightest source") {
  const auto quantum = [](const std::string& text) { return plan_of(text).quantum; };
  for (const char* text : {"square", "background E 0.3", "light E 0 5 0 1 square",
                           "falloff square intensity 7e4 light E 0 5 0 1 square",
                           "defaultMaterials emissive 9 9 9 square"}) {
    int exponent = 0;
    CHECK(std::frexp(quantum(text), &exponent) == 0.5);
  }
  CHECK(quantum("background E 0.25") == 0.25 * quantum("background E 1"));
  // light that falls off: the same scene, twice as large and with four times the power
  CHECK(quantum("falloff square intensity 1 light E 0 0 3 1 square") ==
        quantum("falloff square intensity 4 light E 0 0 6 1 scale 2 2 2 square"));
}

// Relative to its size the scene is the same wherever it stands.
TEST_CASE("the quantum does not depend on where in space the scene is") {
  const std::string scene = "light E 0 0 1 1 square";
  CHECK(plan_of("falloff square " + scene).quantum ==
        plan_of("eye 100000 0 5 lookAt 100000 0 0 falloff square translate 100000 0 0 " + scene)
            .quantum);
}

TEST_CASE("a surface far from the origin and close to a light does not overflow the film") {
  const Rendering r = test::render_scene(
      test::scene_from("eye 100000 0 5 lookAt 100000 0 0 imageSize 4 4 samples 64 falloff square "
                       "translate 100000 0 0 light E 0 0 1 1 square"),
      true);
  CHECK(r.film.refused().overflow == 0);
  CHECK(r.film.color(2, 2).y > 0.0);
}

TEST_CASE("the farthest coordinate is that of shape, light or eye") {
  const auto farthest = [](const std::string& text) {
    return farthest_coordinate(test::scene_from(text));
  };
  CHECK(farthest("eye 1 -9 2 lookAt 0 0 0") == 9.0);
  CHECK(farthest("translate 20 0 0 sphere") == Approx(21.0));
  CHECK(farthest("light E 0 0 -30 1 sphere") == 30.0);
  CHECK(farthest("spotlight E 0 40 0 1 0 -1 0 5 sphere") == 40.0);
  CHECK(farthest("light E 0 1000 0 0 sphere") == 5.0); // parallel light has no place
  // Rays may begin anywhere on a thin lens, or on the first surface of a real one.
  CHECK(farthest("eye 0 -9 0 lookAt 0 0 -1 aperture 3") == 10.5);
  CHECK(farthest("eye 0 -900 0 lookAt 0 0 -1 lensFile \"" ABBE_SOURCE_DIR
                 "/scenes/lenses/achromat_ac254_050_a.lens\"") >= 912.7);
}

// A white diffuse square, lit head-on at strength 1, shows the light's own colour.
TEST_CASE("a light's white does not change with the number of bands") {
  for (const std::string lamp : {"D65", "E", "A", "FL11", "2a"}) {
    const Scene scene =
        test::scene_from(kLibrary +
                         "eye 0 0 5000 lookAt 0 0 0 fieldOfView 0.001 imageSize 1 1 samples 1\n"
                         "light " +
                         lamp +
                         " 0 0 1000 1\n"
                         "defaultMaterials ambient 0 0 0 diffuse 1 1 1 square");
    const Xyz white = to_xyz(scene.lights[0].spectrum);
    for (const int bands : {1, 3, 9, 27, 81, 10, 60}) {
      CAPTURE(lamp, bands);
      RenderSettings settings = scene.settings;
      settings.bands = bands;
      Scene s = scene;
      s.settings = settings;
      const Xyz seen = test::render_scene(s, false).film.color(0, 0);
      CHECK(seen.x == Approx(white.x).epsilon(1e-6));
      CHECK(seen.y == Approx(white.y).epsilon(1e-6));
      CHECK(seen.z == Approx(white.z).epsilon(1e-6));
    }
  }
}

TEST_CASE("an endless plane makes the scene no larger") {
  const std::string text = kLibrary + "falloff square light 2a 0 5 0 1 translate 0 0 3 sphere ";
  const Scene bounded = test::scene_from(text), endless = test::scene_from(text + "plane");
  CHECK(farthest_coordinate(bounded) == 5.0);
  CHECK(farthest_coordinate(endless) == 5.0);
  const BandGrid grid(81);
  CHECK(film_quantum(endless, grid, Observer::cie1931_2deg) ==
        film_quantum(bounded, grid, Observer::cie1931_2deg));
}
