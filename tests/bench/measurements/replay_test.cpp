#include "bench/measurements/replay.h"
#include "bench/measurements/setup.h"
#include "core/planning/make_plan.h"
#include "tests/catch.h"
#include "tests/render_text.h"

using namespace abbe;
using namespace abbe::bench;

namespace {

struct Recorded {
  Scene scene;
  World world;
  RayCounts counts;
  std::vector<RaysOfKind> kinds;
};

Recorded recorded(const char* name, ShadowRule shadows) {
  Scene scene = test::project_scene(name, 24);
  scene.settings.samples_per_pixel = 2;
  scene.settings.threads = 1;
  scene.settings.shadows = shadows;
  World world = build_world(scene);
  RayRecord record;
  const Rendering rendering = render_once(scene, make_plan(scene, scene.settings), world, &record);
  return {std::move(scene), std::move(world), rendering.rays, by_kind(record)};
}

std::size_t hits(const World& world, const RaysOfKind& rays) {
  std::size_t met = 0;
  for (std::size_t i = 0; i < rays.states.size(); ++i)
    met += rays.any_hit ? world.occluded(rays.states[i], rays.distances[i])
                        : world.closest(rays.states[i]).has_value();
  return met;
}

} // namespace

TEST_CASE("the record holds every ray that is counted") {
  for (const char* name : {"sphere", "lens", "prism_view"}) {
    INFO(name);
    Recorded r = recorded(name, ShadowRule::attenuated);
    REQUIRE(r.kinds.size() == 4);
    for (const RaysOfKind& rays : r.kinds) {
      CHECK(rays.states.size() == r.counts.of(rays.kind));
      CHECK(rays.distances.size() == rays.states.size());
      CHECK_FALSE(rays.any_hit);
    }
  }
}

TEST_CASE("with caustics the rays of lights and of walls are recorded too") {
  Scene scene = test::project_scene("newton", 16);
  scene.settings.samples_per_pixel = 1;
  scene.settings.threads = 1;
  const World world = build_world(scene);
  RayRecord record;
  const Rendering rendering = render_once(scene, make_plan(scene, scene.settings), world, &record);
  std::vector<RayKind> kinds;
  RayCounts counts = rendering.rays;
  for (const RaysOfKind& rays : by_kind(record)) {
    INFO(bench::name(rays.kind));
    kinds.push_back(rays.kind);
    CHECK(rays.states.size() == counts.of(rays.kind));
    CHECK(query(world, rays, 1) == hits(world, rays));
  }
  CHECK(kinds == std::vector(kRayKinds.begin(), kRayKinds.end())); // all of them
}

TEST_CASE("recording changes nothing of the image") {
  const Scene scene = [] {
    Scene s = test::project_scene("lens", 16);
    s.settings.samples_per_pixel = 2;
    s.settings.threads = 1;
    return s;
  }();
  const World world = build_world(scene);
  const Plan plan = make_plan(scene, scene.settings);
  RayRecord record;
  const Rendering with = render_once(scene, plan, world, &record);
  const Rendering without = render_once(scene, plan, world);
  CHECK(with.rays.total() == without.rays.total());
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      REQUIRE(with.film.color(x, y) == without.film.color(x, y));
}

TEST_CASE("recorded rays meet the same in the world and in raw Embree, at any width") {
  for (const char* name : {"sphere", "lens", "prism_view"})
    for (const ShadowRule shadows : {ShadowRule::attenuated, ShadowRule::opaque}) {
      const Recorded r = recorded(name, shadows);
      for (const RaysOfKind& rays : r.kinds) {
        INFO(name << ", " << bench::name(rays.kind));
        // Raw Embree sees boundaries that do not show, too; these scenes have none that matter
        // outside glass, where every ray that meets nothing in the end leaves the scene.
        const std::size_t expected = hits(r.world, rays);
        CHECK(query(r.world, rays, 2) == expected);
        if (rays.any_hit) continue; // there raw Embree leaves glass to a second query
        for (const int width : kPacketWidths)
          CHECK(replay(r.world, rays, width, 2) == expected);
      }
    }
}

TEST_CASE("opaque shadow rays are recorded with the distance to their light") {
  const Recorded r = recorded("sphere", ShadowRule::opaque);
  const RaysOfKind& shadow = r.kinds.back();
  REQUIRE(shadow.kind == RayKind::shadow);
  CHECK(shadow.any_hit);
  for (const double distance : shadow.distances)
    REQUIRE(distance < kInfinity);
  CHECK(replay(r.world, shadow, 1, 1) <= hits(r.world, shadow));
}
