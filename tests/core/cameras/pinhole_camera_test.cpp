#include "core/cameras/pinhole_camera.h"
#include "tests/catch.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace abbe;

namespace {
constexpr double kDegree = std::numbers::pi / 180.0;
const Camera kOblique{{1.0, 2.0, 3.0}, {-2.0, 0.5, -4.0}, {0.1, 1.0, 0.2}, 37.0, Pinhole{}};
} // namespace

TEST_CASE("a point on a camera ray appears where the ray left") {
  const PinholeCamera camera(kOblique, 640, 480);
  for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(640, 480), glm::dvec2(12.3, 400.1)})
    for (const double t : {1e-3, 1.0, 1e5}) {
      const Ray ray = camera.ray(p);
      CHECK(glm::length(ray.direction) == Approx(1.0).epsilon(1e-15));
      CHECK(ray.origin == kOblique.eye);
      const auto seen = camera.project(ray.origin + t * ray.direction);
      REQUIRE(seen);
      CHECK(glm::distance(*seen, p) < 1e-8);
    }
}

TEST_CASE("what is behind the camera or beside its eye appears nowhere") {
  const PinholeCamera camera({}, 100, 100); // from (0, 0, 5) along -z
  CHECK(camera.project({0.0, 0.0, 4.9}));
  CHECK_FALSE(camera.project({0.0, 0.0, 5.1}));
  CHECK_FALSE(camera.project({1.0, 0.0, 5.0}));
  CHECK_FALSE(camera.project({0.0, 0.0, 5.0}));
}

TEST_CASE("the middle of the picture looks at lookAt") {
  const PinholeCamera camera(kOblique, 640, 480);
  const dvec3 direction = camera.ray({320.0, 240.0}).direction;
  CHECK(glm::distance(direction, glm::normalize(kOblique.look_at - kOblique.eye)) < 1e-15);
}

TEST_CASE("the field of view is the angle between the upper and the lower edge") {
  for (const int width : {10, 640, 3000}) { // whatever the width
    const PinholeCamera camera(kOblique, width, 480);
    const double middle = 0.5 * width;
    const dvec3 upper = camera.ray({middle, 0.0}).direction;
    const dvec3 lower = camera.ray({middle, 480.0}).direction;
    CHECK(std::acos(glm::dot(upper, lower)) == Approx(37.0 * kDegree).epsilon(1e-12));
  }
}

TEST_CASE("pixels are square, x runs to the right and y downwards") {
  const PinholeCamera camera({}, 200, 100);
  const dvec3 middle = camera.ray({100.0, 50.0}).direction;
  const dvec3 right = camera.ray({101.0, 50.0}).direction - middle;
  const dvec3 down = camera.ray({100.0, 51.0}).direction - middle;
  CHECK(right.x > 0.0);
  CHECK(right.y == Approx(0.0).margin(1e-15));
  CHECK(down.y < 0.0);
  CHECK(down.x == Approx(0.0).margin(1e-15));
  CHECK(right.x == Approx(-down.y).epsilon(1e-12));
}

// A pixel in the middle has the height 2 tan(fov / 2) / rows at unit distance.
TEST_CASE("the pixel's angle is that between two neighbours in the middle") {
  const PinholeCamera camera({}, 200, 100);
  CHECK(camera.pixel_angle() == Approx(2.0 * std::tan(15.0 * kDegree) / 100.0).epsilon(1e-14));
  const double angle =
      std::acos(glm::dot(camera.ray({100.0, 49.5}).direction, camera.ray({100.0, 50.5}).direction));
  CHECK(camera.pixel_angle() == Approx(angle).epsilon(1e-5));
}
