#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cstring>
#include <functional>

using namespace abbe;

namespace {

/// Glass, a mirror, coloured surfaces, three kinds of lamps, and empty tiles.
Scene everything() {
  return test::scene_from(
      "imageSize 48 40 samples 5 maxFan 6 eye 0 1 7 lookAt 0 0 0 fieldOfView 34\n"
      "lights \"" ABBE_SOURCE_DIR "/scenes/lights.filter\"\n"
      "light 2a 3 4 5 1 falloff square intensity 30 light 2a -3 4 2 1\n"
      "softEdge 2 spotlight 2a 0 3 3 1 0 -1 -1 20\n"
      "push translate -0.8 0 0 scale 0.8 0.8 0.8 glass SF11 sphere pop\n"
      "push translate 1 0 0 scale 0.7 0.7 0.7 rotate 30 1 1 0 defaultMaterials\n"
      "diffuse 0.8 0.3 0.1 reflectivity 0.3 specular 0.3 0.3 0.3\n"
      "specularExponent 20 cube pop\n"
      "push translate 0 -1 0 rotate -90 1 0 0 defaultMaterials square pop\n");
}

Rendering render_with(const std::function<void(RenderSettings&)>& change) {
  Scene scene = everything();
  change(scene.settings);
  return test::render_scene(scene, true);
}

bool same_sums(const Film& a, const Film& b) {
  const PixelWindow w = a.window();
  for (int y = w.y0; y < w.y1; ++y)
    for (int x = w.x0; x < w.x1; ++x) {
      if (!(a.color(x, y) == b.color(x, y)) || a.alpha(x, y) != b.alpha(x, y)) return false;
      for (int band = 0; band < a.bands(); ++band)
        if (a.radiance(x, y, band) != b.radiance(x, y, band)) return false;
    }
  return true;
}

} // namespace

TEST_CASE("threads, packets and skipping change no sum of the film, and the seed changes it") {
  const Rendering reference = render_with([](RenderSettings& s) { s.threads = 1; });
  CHECK(reference.film.refused().not_finite == 0);
  CHECK(reference.film.refused().negative == 0);
  CHECK(reference.film.refused().overflow == 0);
  CHECK(reference.film.color(24, 20).y > 0.0);
  const auto same_with = [&](const std::function<void(RenderSettings&)>& change) {
    return same_sums(reference.film, render_with(change).film);
  };
  CHECK(same_with([](RenderSettings& s) { s.threads = 2; }));
  CHECK(same_with([](RenderSettings& s) { s.threads = 7; }));
  CHECK(same_with([](RenderSettings& s) { s.tracing = Tracing::single; }));
  CHECK(same_with([](RenderSettings& s) { s.skip = false; }));
  CHECK_FALSE(same_with([](RenderSettings& s) { s.seed = 1; }));
}

TEST_CASE("a crop shows the same pixels as the whole picture") {
  const Rendering whole = render_with([](RenderSettings&) {});
  const Rendering part =
      render_with([](RenderSettings& s) { s.crop = PixelWindow{9, 11, 30, 29}; });
  for (int y = 11; y < 29; ++y)
    for (int x = 9; x < 30; ++x)
      REQUIRE(part.film.color(x, y) == whole.film.color(x, y));
}

TEST_CASE("every pixel gets its samples, also when they need several passes") {
  const Rendering r = render_with([](RenderSettings& s) { s.samples_per_pixel = 37; });
  CHECK(r.complete);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 48; ++x)
      REQUIRE(r.film.samples(x, y) == 37);
}

TEST_CASE("progress grows to 1 and counts every ray") {
  const Scene scene = everything();
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  double last = 0.0;
  std::uint64_t rays = 0;
  const auto tell = [&](const RenderProgress& p) {
    CHECK(p.fraction > last);
    last = p.fraction;
    rays = p.rays.total();
  };
  const Rendering r = render(scene, plan, world, {}, {.progress = tell});
  CHECK(last == 1.0);
  CHECK(rays == r.rays.total());
  CHECK(r.rays.camera > 0);
  CHECK(r.rays.reflected > 0);
  CHECK(r.rays.refracted > 0);
  CHECK(r.rays.shadow > 0);
}

TEST_CASE("a rendering that is stopped says so and keeps what is done") {
  const Scene scene = everything();
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  std::atomic<bool> stop = true;
  const Rendering none = render(scene, plan, world, {}, {.stop = &stop});
  CHECK_FALSE(none.complete);
  CHECK(none.film.samples(0, 0) == 0);
  CHECK(none.film.color(24, 20) == Xyz{0.0, 0.0, 0.0});

  stop = false;
  const auto stop_at = [&](double fraction) {
    const auto tell = [&](const RenderProgress& p) { stop = stop || p.fraction >= fraction; };
    return render(scene, plan, world, {}, {.progress = tell, .stop = &stop});
  };
  const Rendering late = stop_at(1.0); // all was done before the stop
  CHECK(late.complete);
  CHECK(late.film.samples(47, 39) == 5);
}
