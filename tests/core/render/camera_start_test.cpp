#include "core/planning/make_plan.h"
#include "core/render/camera_start.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <glm/geometric.hpp>

#include <vector>

using namespace abbe;

namespace {

/// White light all around, and a ball about the camera.
struct Seen {
  Scene scene;
  Plan plan;
  PlacedCamera camera;

  explicit Seen(const CameraKind& kind)
      : scene(scene_with(kind)), plan(make_plan(scene, scene.settings)),
        camera(scene, scene.settings, World(scene.shapes, 2000.0)) {}

  static Scene scene_with(const CameraKind& kind) {
    Scene scene;
    scene.background = Curve::constant(1.0);
    scene.camera.kind = kind;
    scene.settings.width = scene.settings.height = 100;
    scene.materials.emplace_back();
    scene.shapes.push_back({Sphere{}, Transform::scaling(dvec3(2000.0)), {0}, {}, 0});
    return scene;
  }
};

Sampler sampler(std::uint32_t i) {
  return Sampler(3, 4, i, 1);
}

/// Starts four samples, of which each is at another place.
dvec2 place_of(std::uint32_t i) {
  return {20.0 * i + 10.0, 60.0 - 10.0 * i};
}

std::vector<Hit> start_four(const Seen& seen, CameraStart& start) {
  start.clear();
  for (std::uint32_t i = 0; i < 4; ++i)
    start.add(place_of(i), sampler(i));
  for (const RayState& state : start.states())
    CHECK(state.nesting.size() == 1);
  std::vector<Hit> hits(start.states().size());
  for (std::size_t i = 0; i < hits.size(); ++i)
    hits[i].t = static_cast<double>(i);
  CHECK(seen.camera.nesting.size() == 1);
  return hits;
}

/// A camera whose bands share rays: each sample has one, `ray(place, sampler)`.
template <class Camera>
void check_shared(const CameraKind& kind) {
  const Seen seen(kind);
  CameraStart start(seen.plan, seen.camera);
  const auto& camera = std::get<Camera>(seen.camera.camera);
  for (int batch = 0; batch < 2; ++batch) {
    const std::vector<Hit> hits = start_four(seen, start);
    REQUIRE(hits.size() == 4);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const CameraPaths paths = start.paths(i, hits.data());
      REQUIRE(paths.count == 1);
      CHECK(paths.bundles->bands.first == seen.plan.first_band);
      CHECK(paths.bundles->bands.last == seen.plan.last_band);
      CHECK(paths.bundles->weight == 1.0f);
      const Ray ray = camera.ray(place_of(i), sampler(i));
      CHECK(paths.states->ray.origin == ray.origin);
      CHECK(paths.states->ray.direction == ray.direction);
      CHECK(paths.hits->t == static_cast<double>(i));
    }
  }
}

} // namespace

TEST_CASE("samples of a pinhole start with one ray for all bands") {
  check_shared<PinholeCamera>(Pinhole{});
}

TEST_CASE("samples of a thin lens start with one ray for all bands, from a point of the lens") {
  check_shared<ThinLensCamera>(ThinLens{0.5});
}

TEST_CASE("samples of a real lens start with the rays that its bands are parted into") {
  RealLens lens{test::lens_file("singlet_bk7_50")};
  lens.focus_distance = 500.0;
  lens.film_height_mm = 12.0;
  const Seen seen(lens);
  CameraStart start(seen.plan, seen.camera);
  LensFan fan(seen.plan, std::get<LensCamera>(seen.camera.camera));
  for (int batch = 0; batch < 2; ++batch) {
    const std::vector<Hit> hits = start_four(seen, start);
    std::size_t before = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      std::vector<CameraBundle> bundles;
      std::vector<RayState> states;
      fan.sample(place_of(i), sampler(i).pair(kLens), sampler(i).pair(kWavelength), bundles,
                 states);
      const CameraPaths paths = start.paths(i, hits.data());
      REQUIRE(paths.count == bundles.size());
      for (std::size_t k = 0; k < bundles.size(); ++k) {
        CHECK(paths.bundles[k].bands.first == bundles[k].bands.first);
        CHECK(paths.bundles[k].bands.last == bundles[k].bands.last);
        CHECK(paths.states[k].ray.direction == states[k].ray.direction);
        CHECK(paths.hits[k].t == static_cast<double>(before + k));
      }
      before += bundles.size();
    }
    CHECK(before > 4); // dispersion parts some
    CHECK(before == hits.size());
  }
}

TEST_CASE("a place that gets no light through a real lens starts nothing") {
  RealLens lens{test::lens_file("singlet_bk7_50")};
  lens.focus_distance = 500.0;
  lens.film_height_mm = 12.0;
  const Seen seen(lens);
  CameraStart start(seen.plan, seen.camera);
  start.clear();
  start.add({1e4, 1e4}, sampler(0));
  start.add({50.0, 50.0}, sampler(1));
  const std::vector<Hit> hits(start.states().size());
  CHECK(start.paths(0, hits.data()).count == 0);
  CHECK(start.paths(1, hits.data()).count == hits.size());
  CHECK(!hits.empty());
}
