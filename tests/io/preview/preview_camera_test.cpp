#include "io/preview/preview_camera.h"

#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Stands 5 before the origin, and looks at it.
Camera camera() {
  return {};
}

} // namespace

TEST_CASE("a camera goes around the point that it looks at") {
  PreviewWishes wishes;
  CHECK(wished_camera(camera(), wishes).eye == camera().eye);
  wishes.orbit = {30.0 * kDegree, 0.0}; // the picture turns to the right, the eye to the left
  const dvec3 left = wished_camera(camera(), wishes).eye;
  CHECK(left.x == Approx(-2.5));
  CHECK(left.y == Approx(0.0).margin(1e-15));
  CHECK(left.z == Approx(5.0 * std::sqrt(0.75)));
  wishes.orbit = {0.0, 30.0 * kDegree}; // the eye rises
  wishes.distance = 2.0;
  const dvec3 above = wished_camera(camera(), wishes).eye;
  CHECK(above.x == Approx(0.0).margin(1e-14));
  CHECK(above.y == Approx(5.0));
  CHECK(above.z == Approx(10.0 * std::sqrt(0.75)));
}

TEST_CASE("a camera does not go over the pole") {
  PreviewWishes wishes;
  wishes.orbit = {0.0, 3.0};
  const dvec3 eye = wished_camera(camera(), wishes).eye;
  CHECK(glm::length(eye) == Approx(5.0));
  CHECK(eye.y > 4.99);
  CHECK(eye.z > 0.0);
}

TEST_CASE("an aperture makes a lens of a pinhole, and a focus goes with it") {
  PreviewWishes wishes;
  wishes.focus_distance = 4.0;
  CHECK(std::holds_alternative<Pinhole>(wished_camera(camera(), wishes).kind));
  wishes.aperture = 0.5;
  const Camera opened = wished_camera(camera(), wishes);
  const auto& lens = std::get<ThinLens>(opened.kind);
  CHECK(lens.aperture == 0.5);
  CHECK(lens.focus_distance == 4.0);
  wishes.aperture = 0.0;
  CHECK(std::holds_alternative<Pinhole>(wished_camera(opened, wishes).kind));
}

TEST_CASE("the lines of a camera are those of the scene language") {
  Camera own = camera();
  own.eye = {0.1, 2.0, -3.5};
  CHECK(camera_lines(own) == "eye 0.1 2 -3.5\nlookAt 0 0 0\nup 0 1 0\nfieldOfView 30\n");
  own.kind = ThinLens{0.25, 4.5};
  CHECK(camera_lines(own).ends_with("fieldOfView 30\naperture 0.25\nfocusDistance 4.5\n"));
}
