#include "core/planning/plan_extent.h"

#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>
#include <string>

using namespace abbe;
using Catch::Matchers::ContainsSubstring;

namespace {

Scene with_ball(double scale, const dvec3& place = dvec3(0.0)) {
  Scene scene;
  scene.shapes.push_back(
      {Sphere{}, Transform::translation(place).after(Transform::scaling(dvec3(scale))), {}, {}, 0});
  return scene;
}

} // namespace

TEST_CASE("what is too far off for rays is refused by name") {
  CHECK_NOTHROW(check_extent(with_ball(1.0)));
  CHECK_NOTHROW(check_extent(with_ball(0.9e17)));
  CHECK_THROWS_WITH(check_extent(with_ball(1e19)), ContainsSubstring("shape number 1 is too far"));
  CHECK_THROWS_WITH(check_extent(with_ball(1.0, {1e30, 0, 0})),
                    ContainsSubstring("shape number 1"));

  Scene eye = with_ball(1.0);
  eye.camera.eye = {1e160, 0.0, 1e160};
  CHECK_THROWS_WITH(check_extent(eye), ContainsSubstring("the camera's eye is too far"));

  Scene lamp = with_ball(1.0);
  lamp.lights.emplace_back().kind = PointLight{{0.0, 1e40, 1e40}};
  CHECK_THROWS_WITH(check_extent(lamp), ContainsSubstring("light number 1 is too far"));

  Scene plane;
  plane.shapes.push_back({Plane{}, Transform::translation({1e30, 0.0, -1e10}), {}, {}, 0});
  CHECK_NOTHROW(check_extent(plane)); // it passes the origin at 1e10
  plane.shapes[0].to_world = Transform::translation({0.0, 0.0, -1e30});
  CHECK_THROWS_WITH(check_extent(plane), ContainsSubstring("shape number 1"));
}

TEST_CASE("a scene too small for single precision is refused") {
  Scene scene = with_ball(1e-40);
  CHECK_NOTHROW(check_extent(scene)); // the camera is 5 away
  scene.camera.eye = {0.0, 0.0, 5e-40};
  CHECK_THROWS_WITH(check_extent(scene), ContainsSubstring("smaller units"));
}

// The brightest of these lights is 1e15: between 2^49 and 2^50. Half of the quantum is 2^12 = 4096.
TEST_CASE("a light that the film has no numbers for is told") {
  const auto notes = [](const std::string& lights) {
    const Scene scene = test::scene_from(lights + " sphere");
    std::string all;
    for (const std::string& note : make_plan(scene, scene.settings).notes)
      all += note + "\n";
    return all;
  };
  CHECK(notes("light E 2 3 4 1 light E 2 3 -4 1").find("fainter") == std::string::npos);
  const std::string told = notes("light E 2 3 4 1 intensity 1e15 light E 2 3 -4 1");
  CHECK(told.find("light number 1 is fainter than 2^-37 of the brightest") != std::string::npos);
  CHECK(told.find("light number 2") == std::string::npos);
  CHECK(notes("intensity 1e5 light E 2 3 4 1 intensity 1e15 light E 2 3 -4 1").find("fainter") ==
        std::string::npos);
}

TEST_CASE("a scene so far off that its places are coarse is told of") {
  const auto told = [](const std::string& x) {
    const Scene scene = test::scene_from("background E 1 eye " + x + " 0 5 lookAt " + x +
                                         " 0 0 translate " + x + " 0 0 sphere");
    const Plan plan = make_plan(scene, scene.settings);
    return std::any_of(plan.notes.begin(), plan.notes.end(), [](const std::string& note) {
      return note.find("times its size away from the origin") != std::string::npos;
    });
  };
  CHECK_FALSE(told("0"));
  CHECK_FALSE(told("1e6"));
  CHECK_FALSE(told("1e9")); // 1.1e-7 of a unit, and the ball is 2 units wide
  CHECK(told("1e10"));
}
