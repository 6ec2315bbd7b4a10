#include "core/cameras/placed_camera.h"
#include "tests/catch.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <vector>

using namespace abbe;

namespace {

/// From (0, 0, 5) along -z, 30 degrees high, inside a ball.
Scene scene_with(const CameraKind& kind) {
  Scene scene;
  scene.camera.kind = kind;
  scene.settings.width = 200;
  scene.settings.height = 100;
  scene.shapes.push_back({Sphere{}, Transform::scaling(dvec3(20.0)), {}, {}, 0});
  return scene;
}

constexpr double kRim = 10.0; ///< mm, of the lens below

RealLens real_lens() {
  LensPrescription both_round;
  both_round.surfaces = {{60.0, 4.0, ConstantIndex{1.5}, kRim},
                         {-60.0, 0.0, ConstantIndex{1.0}, kRim}};
  RealLens lens{both_round};
  lens.focus_distance = std::numeric_limits<double>::infinity();
  lens.film_height_mm = 24.0;
  return lens;
}

PlacedCamera placed(const Scene& scene) {
  return {scene, scene.settings, World(scene.shapes, 20.0)};
}

} // namespace

TEST_CASE("each kind of camera answers each question") {
  const double pinhole_pixel = 2.0 * std::tan(std::numbers::pi / 12.0) / 100.0;
  struct Expected {
    CameraKind kind;
    double pixel_angle;
    bool connects; ///< and has a projection
    double reach;
  };
  // By the lensmaker's formula; focused at infinity, the film is at the focus.
  const double focal_length = 2.0 / (2.0 / 60.0 - 0.5 * 4.0 / (1.5 * 60.0 * 60.0));
  std::vector<bool> met(std::variant_size_v<CameraKind>, false);
  for (const Expected& e :
       {Expected{Pinhole{}, pinhole_pixel, true, 0.0},
        Expected{ThinLens{0.5}, pinhole_pixel, false, 0.25},
        Expected{real_lens(), 24.0 / focal_length / 100.0, false, std::numbers::sqrt2 * kRim}}) {
    CAPTURE(e.kind.index());
    met[e.kind.index()] = true;
    const Scene scene = scene_with(e.kind);
    const PlacedCamera camera = placed(scene);
    CHECK(camera.camera.index() == e.kind.index());
    CHECK(camera.nesting.size() == 1);
    CHECK(camera.pixel_angle() == Approx(e.pixel_angle).epsilon(1e-6));
    CHECK(camera.connects() == e.connects);
    CHECK(camera.connect({0.1, 0.2, 0.0}).has_value() == e.connects);
    CHECK(static_cast<bool>(projection(scene, 200, 100)) == e.connects);
    CHECK(camera_reach(scene) == Approx(e.reach).epsilon(1e-14));
  }
  for (const bool kind_is_met : met)
    CHECK(kind_is_met);
}

TEST_CASE("a real lens reaches less far in a scene of a larger unit") {
  Scene scene = scene_with(real_lens());
  const double in_mm = camera_reach(scene);
  scene.mm_per_unit = 10.0;
  CHECK(camera_reach(scene) == Approx(0.1 * in_mm).epsilon(1e-14));
}

TEST_CASE("a point that is connected with the camera appears where the camera looks for it") {
  const Scene scene = scene_with(Pinhole{});
  const PlacedCamera camera = placed(scene);
  const Projection project = projection(scene, 200, 100);
  const PinholeCamera rays(scene.camera, 200, 100);
  for (const glm::dvec2 film : {glm::dvec2(100.0, 50.0), glm::dvec2(3.0, 90.0)}) {
    const Ray ray = rays.ray(film);
    const auto seen = camera.connect(ray.at(3.0));
    REQUIRE(seen);
    CHECK(glm::distance(seen->film, film) < 1e-9);
    CHECK(glm::distance(*project(ray.at(3.0)), film) < 1e-9);
    CHECK(glm::distance(seen->direction, -ray.direction) < 1e-14);
    CHECK(seen->distance == Approx(3.0).epsilon(1e-14));
  }
  CHECK_FALSE(camera.connect({0.0, 0.0, 6.0})); // behind it
  CHECK_FALSE(project({0.0, 0.0, 6.0}));
}

// A pixel that sees nothing but a surface of the radiance 1 has the mean radiance 1, however far or
// oblique the surface is: what its places send to the camera, by cosine and area, over
// inverse_importance, is 1 in all.
TEST_CASE("the importances of what a pixel sees add up to one") {
  const Scene scene = scene_with(Pinhole{});
  const PlacedCamera camera = placed(scene);
  const PinholeCamera rays(scene.camera, 200, 100);
  const dvec3 normal = glm::normalize(dvec3(0.3, 0.5, 0.8));
  const auto on_plane = [&](double x, double y) { // through the origin
    const Ray ray = rays.ray({x, y});
    return ray.at(-glm::dot(ray.origin, normal) / glm::dot(ray.direction, normal));
  };
  for (const glm::dvec2 corner : {glm::dvec2(100.0, 50.0), glm::dvec2(10.0, 90.0)}) {
    constexpr int kParts = 16;
    double sum = 0.0;
    for (int i = 0; i < kParts; ++i)
      for (int j = 0; j < kParts; ++j) {
        const double x = corner.x + (i + 0.5) / kParts, y = corner.y + (j + 0.5) / kParts;
        const double half = 0.5 / kParts;
        const dvec3 across = on_plane(x + half, y) - on_plane(x - half, y);
        const dvec3 down = on_plane(x, y + half) - on_plane(x, y - half);
        const double area = glm::length(glm::cross(across, down));
        const auto seen = camera.connect(on_plane(x, y));
        REQUIRE(seen);
        sum += std::abs(glm::dot(seen->direction, normal)) * area / seen->inverse_importance;
      }
    CHECK(sum == Approx(1.0).epsilon(1e-6));
  }
}
