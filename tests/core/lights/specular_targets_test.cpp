#include "core/lights/specular_targets.h"
#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

struct Targets {
  std::vector<EmissionTarget> balls;
  ParallelTargets parallel;
};

Targets targets_of(const std::string& text) {
  const Scene scene = test::scene_from("eye 0 0 9 " + text);
  const Plan plan = make_plan(scene, scene.settings);
  return {specular_targets(scene, plan), parallel_targets(scene, plan)};
}

} // namespace

TEST_CASE("targets are balls around what mirrors or refracts") {
  const Targets targets = targets_of("push translate 1 2 3 glass SF11 cube pop\n"
                                     "defaultMaterials square");
  REQUIRE(targets.balls.size() == 1);
  CHECK(glm::distance(targets.balls[0].center, dvec3(1, 2, 3)) < 1e-12);
  CHECK(targets.balls[0].radius == Approx(std::sqrt(3.0)).epsilon(1e-9));
  CHECK(targets.parallel.area() == Approx(3.0 * std::numbers::pi).epsilon(1e-9));
  CHECK(targets_of("square sphere").balls.empty());
  CHECK(targets_of("square sphere").parallel.empty());
}

// The square of the floor and the eye span a box from (-1, -1, 0) to (1, 1, 9), in a ball about
// (0, 0, 4.5); the mirror z = -1 shows that ball 5.5 behind it.
TEST_CASE("a mirror without end is aimed at through the image of the ball about the scene") {
  const Targets targets =
      targets_of("square push translate 0 0 -1 reflectivity 0.5 fresnel off plane pop");
  REQUIRE(targets.balls.size() == 1);
  CHECK(std::isinf(targets.balls[0].radius));
  const double radius = std::sqrt(1.0 + 1.0 + 4.5 * 4.5);
  CHECK(targets.parallel.area() == Approx(std::numbers::pi * radius * radius).epsilon(1e-9));
  // From below, to the ball about (0, 0, -6.5).
  const ParallelSample line = targets.parallel.sample({1, 0, 0}, {0.2, 0.6});
  CHECK(std::hypot(line.place.y, line.place.z + 6.5) < radius);
}
