#include "core/lights/emission.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

using std::numbers::pi;

/// Light paths of a scene's lights as they set off, and the flux that meets something.
struct Flux {
  std::size_t lights = 0;
  double meeting = 0.0;
  double on_first_shape = 0.0; ///< the part of it that meets the scene's first shape
};

Flux flux_of(const std::string& text) {
  const Scene scene = test::scene_from("integrator path\n" + text);
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  Emission emission(scene, plan);
  emission.place(world);
  Flux flux;
  flux.lights = emission.lights().size();
  constexpr int kPaths = 1 << 15;
  for (const EmittingLight& light : emission.lights())
    for (int i = 0; i < kPaths; ++i)
      if (const auto ray = light.sample(Sampler(0, 0, static_cast<std::uint32_t>(i), 1)))
        if (const auto hit = world.closest(ray->state)) {
          flux.meeting += ray->flux / kPaths;
          if (hit->shape == ShapeId{0}) flux.on_first_shape += ray->flux / kPaths;
        }
  return flux;
}

} // namespace

// Per unit of the light's spectrum: a point's intensity is 1, parallel light's irradiance pi, an
// area light's radiance 1.

TEST_CASE("the flux of a point through a ball is the ball's solid angle") {
  // sin = 1/2: 2 pi (1 - sqrt(3)/2).
  const Flux flux = flux_of("falloff square light E 0 0 2 1 glass SF11 sphere");
  CHECK(flux.lights == 1);
  CHECK(flux.meeting == Approx(2.0 * pi * (1.0 - std::sqrt(0.75))).epsilon(1e-3));
}

TEST_CASE("overlapping targets are not counted twice") {
  const Flux one = flux_of("falloff square light E 0 0 9 1 glass SF11 scale 2 2 2 sphere");
  const Flux two = flux_of("falloff square light E 0 0 9 1 glass SF11 sphere scale 2 2 2 sphere");
  CHECK(two.meeting == Approx(one.meeting).epsilon(2e-3));
}

TEST_CASE("the flux of parallel light through a ball is pi times its disc") {
  const Flux flux = flux_of("light E 0.3 1 0.2 0 glass SF11 scale 2 2 2 sphere");
  CHECK(flux.meeting == Approx(pi * pi * 4.0).epsilon(1e-3));
}

TEST_CASE("the flux of a spotlight in a ball that covers it is that of its cone") {
  const double cone = 2.0 * pi * (1.0 - std::cos(pi / 180.0));
  const Flux flux =
      flux_of("falloff square spotlight E 0 0 20 1 0 0 -1 1 glass SF11 scale 3 3 3 sphere");
  CHECK(flux.meeting == Approx(cone).epsilon(1e-6));
}

TEST_CASE("a wide spotlight sends paths to the glass alone") {
  const Flux flux = flux_of("falloff square spotlight E 0 0 2 1 0 0 -1 80 glass SF11 sphere");
  CHECK(flux.meeting == Approx(2.0 * pi * (1.0 - std::sqrt(0.75))).epsilon(1e-3));
}

TEST_CASE("the flux of a square through a small far ball is radiance times etendue") {
  // Area 4, ball of radius 1 at 100: 4 * pi (1/100)^2, to the order of (2/100)^2.
  const Flux flux = flux_of("glass SF11 sphere\n"
                            "defaultMaterials diffuse 0 0 0 emissive E emissiveSides front\n"
                            "translate 0 0 100 rotate 180 1 0 0 square");
  CHECK(flux.meeting == Approx(4.0 * pi * 1e-4).epsilon(2e-3));
}

TEST_CASE("a square that is seen obliquely sends as much less as it looks smaller") {
  // As above, turned by 60 degrees: half.
  const Flux flux = flux_of("glass SF11 sphere\n"
                            "defaultMaterials diffuse 0 0 0 emissive E emissiveSides front\n"
                            "translate 0 0 100 rotate 120 1 0 0 square");
  CHECK(flux.meeting == Approx(2.0 * pi * 1e-4).epsilon(2e-3));
}

TEST_CASE("a lamp that lies on a card or on glass sends all its light") {
  // The square above, seen by a far ball at an angle of 30 degrees: etendue times its cosine. The
  // card and the glass are behind the lamp.
  const std::string behind[] = {"push scale 3 3 1 square pop",
                                "glass N-BK7 push translate 0 0 -2 scale 2 2 2 cube pop"};
  for (const std::string& back : behind)
    for (const std::string place : {"", "translate 1000 700 -300", "scale 0.0001 0.0001 0.0001"}) {
      const Flux flux = flux_of(place +
                                " rotate 25 1 2 3 glass SF11\n"
                                "push translate 50 0 86.60254037844386 sphere pop\n"
                                "defaultMaterials specular 0 0 0 diffuse 0 0 0\n" +
                                back +
                                "\ndefaultMaterials specular 0 0 0 diffuse 0 0 0 emissive E\n"
                                "emissiveSides front square");
      CAPTURE(back, place);
      // Of the etendue, lengths squared: the scale counts twice.
      const double scale = place.starts_with("scale") ? 1e-4 : 1.0;
      CHECK(flux.on_first_shape ==
            Approx(scale * scale * 4.0 * pi * 1e-4 * std::sqrt(0.75)).epsilon(0.02));
    }
}

TEST_CASE("lights that miss all glass send no paths") {
  CHECK(flux_of("falloff square spotlight E 0 0 9 1 0 0 1 20 glass SF11 sphere").lights == 0);
  CHECK(flux_of("falloff square light E 0 0 9 1 sphere").lights == 0);
  // No flux that could be followed.
  CHECK(flux_of("falloff none light E 0 0 9 1 glass SF11 sphere").lights == 0);
}

TEST_CASE("what does not fall off is an error only where caustics are demanded") {
  const Scene scene =
      test::scene_from("integrator path caustics on light E 0 0 9 1 glass SF11 sphere");
  CHECK_THROWS_WITH(make_plan(scene, scene.settings),
                    Catch::Matchers::ContainsSubstring("does not fall off with distance"));
}
