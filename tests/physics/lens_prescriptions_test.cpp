#include "io/selftest/expected_index.h"
#include "io/selftest/lens_rows.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

using namespace abbe;

TEST_CASE("lenses by their data have their focal lengths at F, d and C") {
  for (const PublishedLens& lens : published_lenses()) {
    INFO(lens.scene);
    const Scene scene = scene_of(lens.scene);
    const World world(scene.shapes, 100.0);
    for (std::size_t line = 0; line < kGlassLines_nm.size(); ++line) {
      const ParaxialFocus f = paraxial_focus(world, scene, kGlassLines_nm[line]);
      CHECK(f.boundaries == lens.surfaces);
      CHECK(f.focal_length == Approx(lens.focal_length[line]).margin(1e-3));
      CHECK(f.focus - lens.back_vertex == Approx(lens.back_focal_length[line]).margin(1e-3));
    }
  }
}

TEST_CASE("a cemented doublet has no air inside: every ray meets its three surfaces only") {
  const Scene scene = scene_of("cemented 2 25.4  33.34 N-BAF10 9  -22.28 SF10 2.5  -291.07");
  const World world(scene.shapes, 100.0);
  for (double x = -12.6; x < 12.7; x += 0.1)
    for (double y = -12.6; y < 12.7; y += 0.1) {
      if (std::hypot(x, y) > 12.69) continue;
      RayState state{{{x, y, -10.0}, {0, 0, 1}}, {}, {}};
      int count = 0;
      while (const auto hit = world.closest(state)) {
        ++count;
        REQUIRE(hit->medium_before.valid() == (count > 1));
        REQUIRE(hit->medium_after.valid() == (count < 3));
        state = hit->going_on(state.ray.direction, true);
      }
      REQUIRE(count == 3);
    }
}
