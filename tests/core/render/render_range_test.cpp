#include "core/film/merge_films.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/render.h"
#include "tests/catch.h"
#include "tests/core/render/same_states.h"
#include "tests/render_text.h"

#include <chrono>
#include <thread>
#include <utility>

using namespace abbe;
using test::check_same;

namespace {

/// A glass ball on a floor and a mirror under a lamp, in several tiles.
Scene glass(const std::string& settings) {
  return test::scene_from(settings +
                          " imageSize 40 24 bands 5 eye 0 1.2 5 fieldOfView 40\n"
                          "background 0.1 0.1 0.2\n"
                          "falloff square intensity 4 light E 1 3 2 1\n"
                          "defaultMaterials diffuse 0.7 0.7 0.7\n"
                          "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                          "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n");
}

/// What ranges of one scene's samples are rendered into.
struct Stage {
  Scene scene;
  Plan plan = make_plan(scene, scene.settings);
  World world = World(scene.shapes, farthest_coordinate(scene));

  [[nodiscard]] RenderState begin() const { return begin_rendering(scene, plan, BandPlace{}); }
  bool render_range(SampleRange range, RenderState& state,
                    const RenderControl& control = {}) const {
    return render(scene, plan, world, range, state, control);
  }
  [[nodiscard]] RenderState all() const {
    RenderState state = begin();
    CHECK(render_range({0, plan.settings.samples_per_pixel}, state));
    return state;
  }
};

Stage stage(Scene scene, int samples) {
  scene.settings.samples_per_pixel = samples;
  return {std::move(scene)};
}

} // namespace

TEST_CASE("one range after the other gives the sums of all samples at once") {
  for (const bool errors : {false, true}) {
    Scene scene = glass("integrator whitted");
    scene.settings.keep_errors = errors;
    const Stage s = stage(scene, 16);
    RenderState state = s.begin();
    CHECK(s.render_range({0, 8}, state));
    CHECK(state.done == 8);
    CHECK(state.film.samples(20, 12) == 8);
    CHECK(s.render_range({8, 11}, state));
    CHECK(s.render_range({8, 11}, state)); // nothing is rendered twice
    CHECK(s.render_range({11, 16}, state));
    check_same(state, s.all());
  }
}

// A pass of light paths is for 16 samples: ranges end at its end, and within it.
TEST_CASE("ranges give the same sums with light passes") {
  for (const char* camera : {"integrator path", "integrator path aperture 0.2 focusDistance 5"}) {
    const Stage s = stage(glass(camera), 40);
    REQUIRE(s.plan.caustics);
    const RenderState whole = s.all();
    CHECK(whole.light.passes == 3);
    CHECK(whole.film.find(kSplats).has_value() == (camera == std::string("integrator path")));
    for (const int cut : {16, 32, 8, 21}) {
      INFO(cut);
      RenderState state = s.begin();
      CHECK(s.render_range({0, cut}, state));
      CHECK(s.render_range({cut, 40}, state));
      check_same(state, whole);
    }
  }
}

TEST_CASE("films of ranges that were rendered apart merge into that of all samples") {
  Scene scene = glass("integrator path caustics off");
  scene.settings.keep_errors = true;
  const Stage s = stage(scene, 16);
  RenderState early = s.begin(), late = s.begin();
  CHECK(s.render_range({8, 16}, late));
  CHECK(late.film.samples(20, 12) == 8);
  CHECK(s.render_range({0, 8}, early));
  const RenderState whole = s.all();
  merge(early.film, late.film);
  check_same(early.film, whole.film);
}

// Samples of several parts need one light pass, and samples of one part need several.
TEST_CASE("the films of all parts of a rendering merge into that of the whole") {
  for (const char* settings :
       {"integrator whitted", "integrator path", "integrator path aperture 0.2 focusDistance 5",
        "integrator path photonRadius 0.05"})
    for (const int samples : {24, 40}) {
      const Stage s = stage(glass(settings), samples);
      const RenderState whole = s.all();
      for (const int count : {2, 3, 5, 24}) {
        INFO(settings << ", " << samples << " samples in " << count << " parts");
        RenderState sum = s.begin();
        for (int number = count; number-- > 0;) {
          const RenderPart part{number, count};
          RenderState state = begin_rendering(s.scene, s.plan, BandPlace{}, part);
          CHECK(s.render_range(samples_of(part, samples), state));
          merge(sum.film, state.film);
          sum.rays += state.rays;
          CHECK((whole.light.passes == 0 || state.light.first_radius == whole.light.first_radius));
        }
        sum.done = samples;
        check_same(sum, whole);
      }
    }
}

TEST_CASE("a part that was stopped goes on as if it had not been") {
  const Stage s = stage(glass("integrator path"), 40);
  const RenderPart part{2, 3};
  const SampleRange range = samples_of(part, 40);
  RenderState once = begin_rendering(s.scene, s.plan, BandPlace{}, part);
  CHECK(s.render_range(range, once));
  RenderState state = begin_rendering(s.scene, s.plan, BandPlace{}, part);
  std::atomic<bool> stop = true;
  CHECK_FALSE(s.render_range(range, state, {.stop = &stop}));
  stop = false;
  int pauses = 0;
  while (!s.render_range(range, state, {.pause_after = 0.002}) && pauses < 10000)
    ++pauses;
  CHECK(pauses > 0);
  check_same(state, once);
}

TEST_CASE("a sample belongs to the part whose range holds it") {
  for (const int samples : {1, 7, 16, 40})
    for (int count = 1; count <= samples; ++count)
      for (int number = 0; number < count; ++number) {
        const SampleRange range = samples_of({number, count}, samples);
        CHECK(range.first < range.last);
        CHECK((number > 0 || range.first == 0));
        CHECK((number + 1 < count || range.last == samples));
        for (int sample = range.first; sample < range.last; ++sample)
          CHECK(part_of_sample(sample, count, samples) == number);
      }
}

TEST_CASE("a rendering that was stopped goes on as if it had not been") {
  struct Case {
    const char* settings;
    AdaptiveSampling adaptive;
    double noise;
  };
  int stops = 0;
  for (const auto& [settings, adaptive, noise] :
       {Case{"integrator whitted", AdaptiveSampling::off, 0.0},
        Case{"integrator path", AdaptiveSampling::off, 0.0},
        Case{"integrator path", AdaptiveSampling::on, 0.0},
        Case{"integrator path", AdaptiveSampling::off, 0.05}}) {
    INFO(settings << " " << static_cast<int>(adaptive) << " " << noise);
    Scene scene = glass(settings);
    scene.settings.adaptive = adaptive;
    scene.settings.noise = noise;
    const Stage s = stage(scene, 48);
    const RenderState whole = s.all();
    RenderState state = s.begin();
    const SampleRange all{0, 48};
    std::atomic<bool> stop = true; // before anything is done
    CHECK_FALSE(s.render_range(all, state, {.stop = &stop}));
    bool complete = false;
    for (int i = 0; i < 200 && !complete; ++i) { // anywhere, in light passes too
      stop = false;
      const std::jthread stopper([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(200 + 100 * i));
        stop = true;
      });
      complete = s.render_range(all, state, {.stop = &stop});
      stops += complete ? 0 : 1;
    }
    CHECK(s.render_range(all, state));
    check_same(state, whole);
  }
  CHECK(stops > 4);
}

// Between mirrors that lose nothing a light path meets some thousand surfaces, and a chunk of
// 256 of them takes far longer than the stop leaves it.
TEST_CASE("light paths are given up within a chunk when the rendering is stopped") {
  const Stage s = stage(test::scene_from("integrator path caustics on imageSize 8 8 bands 5\n"
                                         "eye 0.1 0.2 0.3 lookAt 0 0 -1\n"
                                         "falloff square light 0.2 0 0 1 1 1\n"
                                         "ambient 0 0 0 diffuse 0 0 0 fresnel off reflectivity 1\n"
                                         "sphere\n"),
                        16);
  REQUIRE(s.plan.caustics);
  RenderState state = s.begin();
  std::atomic<bool> stop = false;
  const std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop = true;
  });
  CHECK_FALSE(s.render_range({0, 16}, state, {.stop = &stop}));
  CHECK(state.film.light_passes() == 0.0); // nothing of a chunk that was given up
  CHECK(state.rays.total() == 0);
}

TEST_CASE("a rendering in one call is that of all samples") {
  const Stage s = stage(glass("integrator path"), 20);
  const Rendering rendering = render(s.scene, s.plan, s.world, BandPlace{});
  CHECK(rendering.complete);
  CHECK(rendering.open_tiles == 0);
  check_same(rendering.film, s.all().film);
  CHECK(render(s.scene, s.plan, s.world).film.bands() == 0);
}
