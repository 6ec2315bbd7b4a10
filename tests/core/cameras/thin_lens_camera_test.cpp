#include "core/cameras/thin_lens_camera.h"

#include "core/cameras/focus_distance.h"
#include "core/sampling/sampler.h"
#include "geometry/solids/disc_point.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

using namespace abbe;

namespace {

/// From (0, 0, 5) along -z.
ThinLensCamera thin_lens(double aperture, double focus_distance) {
  return {{aperture, focus_distance}, Camera{}, 100, 80};
}

/// In the same place.
const PinholeCamera kPinhole(Camera{}, 100, 80);

/// Numbers whose disc points are spread over the whole lens.
dvec2 lens_numbers(int i) {
  return Sampler(0, 0, static_cast<std::uint32_t>(i), 7).pair(kLens);
}

dvec3 at_depth(const Ray& ray, double depth) {
  return ray.at((5.0 - depth - ray.origin.z) / ray.direction.z);
}

} // namespace

TEST_CASE("disc points fill the unit disc evenly") {
  constexpr int kCount = 1 << 14;
  int inner = 0, right = 0, upper = 0, wedge = 0;
  for (int i = 0; i < kCount; ++i) {
    const dvec2 p = disc_point(lens_numbers(i));
    const double r2 = p.x * p.x + p.y * p.y;
    REQUIRE(r2 <= 1.0 + 1e-12);
    inner += r2 < 0.5;
    right += p.x > 0.0;
    upper += p.y > 0.0;
    wedge += p.x > 0.0 && p.y > 0.0 && p.y < std::sqrt(3.0) * p.x; // 60 degrees
  }
  CHECK(inner == Approx(0.5 * kCount).epsilon(0.01));
  CHECK(right == Approx(0.5 * kCount).epsilon(0.01));
  CHECK(upper == Approx(0.5 * kCount).epsilon(0.01));
  CHECK(wedge == Approx(kCount / 6.0).epsilon(0.01));
  CHECK(disc_point({0.5, 0.5}) == dvec2(0.0));
}

TEST_CASE("thin lens: all rays of a place meet in the plane of focus, where the pinhole sees it") {
  const ThinLensCamera camera = thin_lens(0.6, 3.0);
  for (const dvec2 position : {dvec2(50.0, 40.0), dvec2(3.0, 71.0)}) {
    const dvec3 sharp = at_depth(kPinhole.ray(position), 3.0);
    for (int i = 0; i < 64; ++i) {
      const Ray ray = camera.ray(position, lens_numbers(i));
      CHECK(glm::distance(at_depth(ray, 3.0), sharp) < 1e-12);
      CHECK(glm::length(ray.direction) == Approx(1.0).epsilon(1e-14));
      CHECK(ray.origin.z == Approx(5.0).epsilon(1e-14));
      CHECK(glm::distance(ray.origin, dvec3(0, 0, 5)) <= 0.3 + 1e-12);
    }
  }
}

// By similar triangles, a lens of diameter A focused at s blurs a point at z to A |z - s| / s
// there.
TEST_CASE("thin lens: the circle of confusion") {
  const double aperture = 0.5, focus = 4.0;
  const ThinLensCamera camera = thin_lens(aperture, focus);
  for (const double z : {1.0, 3.0, 6.0, 40.0}) {
    const dvec3 middle = at_depth(kPinhole.ray({60.0, 30.0}), z);
    double radius = 0.0;
    for (int i = 0; i < 4096; ++i)
      radius = std::max(
          radius, glm::distance(at_depth(camera.ray({60.0, 30.0}, lens_numbers(i)), z), middle));
    CHECK(2.0 * radius == Approx(aperture * std::abs(z - focus) / focus).epsilon(0.01));
  }
}

TEST_CASE("thin lens: focused at infinity, rays of a place are parallel") {
  const ThinLensCamera camera = thin_lens(0.5, std::numeric_limits<double>::infinity());
  const dvec3 direction = kPinhole.ray({10.0, 20.0}).direction;
  for (int i = 0; i < 16; ++i)
    CHECK(glm::distance(camera.ray({10.0, 20.0}, lens_numbers(i)).direction, direction) < 1e-15);
}

TEST_CASE("thin lens: it is focused on lookAt unless told otherwise") {
  Camera camera;
  camera.look_at = {0.0, 3.0, 1.0};
  CHECK(focus_distance(camera, std::nullopt) == Approx(5.0));
  CHECK(focus_distance(camera, 2.0) == 2.0);
}

TEST_CASE("thin lens: a uniform background is as bright as through a pinhole") {
  for (const char* lens : {"", "aperture 0.5 "}) {
    const Scene scene =
        test::scene_from(std::string(lens) + "imageSize 8 8 samples 4 background E 0.25");
    const Rendering r = test::render_scene(scene, false);
    for (int x = 0; x < 8; ++x)
      CHECK(r.film.color(x, x).y == Approx(0.25).epsilon(1e-6));
  }
}

// The edge of a half plane beyond the focus is a ramp as wide as the circle of confusion.
TEST_CASE("thin lens: an edge out of focus is blurred as far as the circle of confusion") {
  // 2 units of height at distance 5, 40 pixels; the plane at 10 is blurred over 1 x (10 - 5) / 5 =
  // 1 there, which is 0.5 in the plane of focus: 10 pixels.
  const Scene scene = test::scene_from(
      "fieldOfView 22.61986494804043 imageSize 40 40 samples 64 filter box aperture 1 "
      "defaultMaterials ambient 1 1 1 diffuse 0 0 0 globalAmbient 1 1 1 "
      "translate 100 0 -5 scale 100 100 1 square");
  const Rendering r = test::render_scene(scene, false);
  const auto mean = [&](int x) {
    double sum = 0.0;
    for (int y = 0; y < 40; ++y)
      sum += r.film.color(x, y).y / 40.0;
    return sum;
  };
  const double white = mean(39);
  CHECK(mean(0) == 0.0);
  CHECK(mean(14) == 0.0);
  CHECK(mean(15) > 0.0);
  CHECK(mean(24) < white);
  CHECK(mean(25) == Approx(white).epsilon(1e-9));
  // Half of the disc lies left of a chord at the middle; a quarter of the width further, the share
  // is 1/2 + (h sqrt(1 - h^2) + asin h) / pi with h = 1/2.
  CHECK(0.5 * (mean(19) + mean(20)) == Approx(0.5 * white).epsilon(0.03));
  CHECK(0.5 * (mean(22) + mean(21)) / white ==
        Approx(0.5 + (0.4 * std::sqrt(1 - 0.16) + std::asin(0.4)) / 3.14159265).epsilon(0.03));
}
