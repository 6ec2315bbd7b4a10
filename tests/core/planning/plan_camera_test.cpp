#include "core/planning/plan_camera.h"

#include "core/cameras/pinhole_camera.h"
#include "tests/catch.h"

#include <array>

using namespace abbe;

namespace {

/// As OpenEXR multiplies: the point is a row.
std::array<double, 4> times(const dvec3& p, const Matrix4& m) {
  std::array<double, 4> result{};
  for (std::size_t j = 0; j < 4; ++j)
    result[j] = p.x * m[0][j] + p.y * m[1][j] + p.z * m[2][j] + m[3][j];
  return result;
}

} // namespace

// From (1, 2, 3) along +x with y upwards, right is +z.
TEST_CASE("camera coordinates go right, up and ahead from the eye") {
  Camera camera;
  camera.eye = {1.0, 2.0, 3.0};
  camera.look_at = {9.0, 2.0, 3.0};
  const Matrix4 m = camera_matrices(camera, 8, 6).world_to_camera;
  CHECK(times({1.0, 2.0, 3.0}, m) == std::array<double, 4>{0.0, 0.0, 0.0, 1.0});
  CHECK(times({6.0, 2.0, 3.0}, m) == std::array<double, 4>{0.0, 0.0, 5.0, 1.0});
  CHECK(times({1.0, 4.0, 3.0}, m) == std::array<double, 4>{0.0, 2.0, 0.0, 1.0});
  CHECK(times({1.0, 2.0, 4.0}, m) == std::array<double, 4>{1.0, 0.0, 0.0, 1.0});
}

TEST_CASE("a point is in the image where the pinhole camera sees it") {
  Camera camera;
  camera.eye = {1.0, -2.0, 7.0};
  camera.look_at = {0.5, 0.3, -1.0};
  camera.up = {0.1, 1.0, 0.2};
  camera.field_of_view_deg = 40.0;
  const Matrix4 m = camera_matrices(camera, 16, 9).world_to_image.value();
  const PinholeCamera pinhole(camera, 16, 9);
  for (const dvec3& point : {dvec3(0.0), dvec3(1.0, 0.5, 0.2), dvec3(-2.0, 3.0, -9.0)}) {
    const auto place = times(point, m);
    const auto pixel = pinhole.project(point).value();
    CHECK(place[0] / place[3] == Approx(pixel.x / 16.0).epsilon(1e-12));
    CHECK(place[1] / place[3] == Approx(pixel.y / 9.0).epsilon(1e-12));
  }
  camera.kind = RealLens{};
  CHECK_FALSE(camera_matrices(camera, 16, 9).world_to_image);
}
