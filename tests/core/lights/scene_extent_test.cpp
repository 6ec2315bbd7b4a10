#include "core/lights/scene_extent.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

TEST_CASE("the scene's size is that of the box around shapes and lights that stand somewhere") {
  Scene scene;
  CHECK(scene_size(scene) == 0.0);
  scene.shapes.push_back({Plane{}, {}, {}, {}, 0});
  scene.lights.push_back({"", Curve::constant(1.0), DirectionalLight{{1, 0, 0}}});
  scene.lights.push_back({"", Curve::constant(1.0), SunLight{{1, 0, 0}}});
  CHECK(scene_size(scene) == 0.0);
  scene.shapes.push_back({Box{}, Transform::translation({4, 0, 0}), {}, {}, 0});
  CHECK(scene_size(scene) == Approx(std::sqrt(12.0)).epsilon(1e-12)); // edges of 2
  scene.lights.push_back({"", Curve::constant(1.0), PointLight{{0, -1, -1}}});
  CHECK(scene_size(scene) == Approx(std::sqrt(25.0 + 8.0)).epsilon(1e-12));
  scene.lights.push_back({"", Curve::constant(1.0), SpotLight{{0, -1, 9}, {1, 0, 0}}});
  CHECK(scene_size(scene) == Approx(std::sqrt(25.0 + 4.0 + 100.0)).epsilon(1e-12));
}
