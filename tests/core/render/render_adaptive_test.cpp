#include "core/adaptive/noise.h"
#include "core/planning/make_plan.h"
#include "core/planning/plan_extent.h"
#include "core/render/tile_renderer.h"
#include "tests/catch.h"
#include "tests/core/render/same_pixels.h"
#include "tests/render_text.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

using namespace abbe;

namespace {

/// A lit floor with a ball, both with edges, and some tiles of background.
Scene ball() {
  Scene scene = test::scene_from(
      "imageSize 64 48 eye 0 1 6 fieldOfView 40 background 0.1 0.2 0.4 globalAmbient 0.1 0.1 0.1\n"
      "light D65 3 4 5 1 defaultMaterials diffuse 0.8 0.5 0.2 specular 0.5 0.5 0.5\n"
      "specularExponent 40 sphere push translate 0 -1 0 rotate -90 1 0 0 square pop");
  scene.settings.bands = 9;
  scene.settings.adaptive = AdaptiveSampling::on;
  return scene;
}

/// A glass ball on a floor under a lamp: light paths, splats and paths.
Scene glass() {
  Scene scene =
      test::scene_from("integrator path imageSize 40 24 eye 0 1.2 5 fieldOfView 40\n"
                       "defaultMaterials emissive D65 8 emissiveSides front diffuse 0 0 0\n"
                       "push translate 0 3 0 rotate 90 1 0 0 scale 0.4 0.4 1 square pop\n"
                       "defaultMaterials diffuse 0.7 0.7 0.7\n"
                       "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                       "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n");
  scene.settings.bands = 9;
  scene.settings.adaptive = AdaptiveSampling::on;
  return scene;
}

Rendering render_with(Scene scene, int samples) {
  scene.settings.samples_per_pixel = samples;
  return test::render_scene(scene, false);
}

/// The relative mean squared error in linear R, G, B.
double relative_mse(const Film& film, const Film& reference) {
  const PixelWindow w = film.window();
  const auto values = 3.0 * static_cast<double>(w.pixel_count());
  double mean = 0.0, sum = 0.0;
  for (const bool counting : {true, false})
    for (int y = w.y0; y < w.y1; ++y)
      for (int x = w.x0; x < w.x1; ++x) {
        const LinearRgb c = to_linear_srgb(film.color(x, y));
        const LinearRgb r = to_linear_srgb(reference.color(x, y));
        for (const auto& [v, t] : {std::pair(c.r, r.r), {c.g, r.g}, {c.b, r.b}})
          if (counting)
            mean += t / values;
          else
            sum += (v - t) * (v - t) / (t * t + 0.01 * mean * mean) / values;
      }
  return sum;
}

} // namespace

TEST_CASE("adaptive sampling gives the same bytes on any number of threads") {
  for (Scene scene : {ball(), glass()}) {
    scene.settings.threads = 1;
    const Rendering one = render_with(scene, 32);
    for (const int threads : {2, 7}) {
      scene.settings.threads = threads;
      CHECK(test::same_pixels(render_with(scene, 32).film, one.film));
    }
    scene.settings.seed = 1;
    CHECK_FALSE(test::same_pixels(render_with(scene, 32).film, one.film));
  }
}

TEST_CASE("samples are what was asked for in the mean, and no pixel goes without") {
  for (const int samples : {1, 2, 8, 16, 50, 64}) {
    const Rendering r = render_with(ball(), samples);
    const SampleCounts counts = sample_counts(r.film);
    INFO(samples);
    CHECK(r.complete);
    CHECK(r.open_tiles == 0);
    CHECK(counts.mean == Approx(samples).epsilon(0.03));
    CHECK(counts.least >= std::min(static_cast<unsigned>(samples), 4u));
    CHECK(counts.least >= static_cast<unsigned>(samples) / 8u);
    CHECK(counts.most <= 8.0 * std::sqrt(2.0) * samples); // rounded to a power of two
    if (samples >= 8) CHECK(counts.most > counts.least);
  }
}

TEST_CASE("passes of a round take equal parts of what a pixel is to get") {
  Film film({5, 6, 7, 8}, 0x1p-40, 0);
  for (std::uint32_t i = 0; i < 4; ++i)
    film.add({6, 7, i, true}, {0.0, 0.0, 0.0}, {});
  const std::vector<std::uint32_t> allocation{0, 0, 0, 14}; // of pixel 6, 7 the last
  const auto range = [&](int passes_left) {
    const SampleRange r = PassSamples(allocation, passes_left).of(film, 6, 7);
    return std::pair(r.first, r.last);
  };
  CHECK(range(3) == std::pair(4, 8));
  CHECK(range(2) == std::pair(4, 9));
  CHECK(range(1) == std::pair(4, 14));
  const SampleRange none = PassSamples(allocation, 1).of(film, 5, 6);
  CHECK(none.last == none.first);
  const SampleRange same = PassSamples({3, 9}).of(film, 6, 7);
  CHECK(std::pair(same.first, same.last) == std::pair(3, 9));
}

TEST_CASE("without adaptive sampling each pixel gets the same") {
  Scene scene = ball();
  scene.settings.adaptive = AdaptiveSampling::off;
  const SampleCounts counts = sample_counts(render_with(scene, 24).film);
  CHECK(counts.least == 24);
  CHECK(counts.most == 24);
}

// Edges hold nearly all of the error, and are a small part of the picture: the ratio is far from 1.
TEST_CASE("adaptive sampling lowers the error at the same number of samples") {
  Scene even = ball();
  even.settings.adaptive = AdaptiveSampling::off;
  Scene seeded = ball();
  even.settings.seed = seeded.settings.seed = 1;
  const Rendering adaptive = render_with(seeded, 32), uniform = render_with(even, 32);
  even.settings.seed = 2;
  const Rendering reference = render_with(even, 1024);
  CHECK(relative_mse(adaptive.film, reference.film) <
        0.6 * relative_mse(uniform.film, reference.film));
}

TEST_CASE("light paths are followed for as many samples as without adaptive sampling") {
  Scene scene = glass();
  const Rendering adaptive = render_with(scene, 40);
  scene.settings.adaptive = AdaptiveSampling::off;
  const Rendering uniform = render_with(scene, 40);
  CHECK(adaptive.rays.light > 0);
  CHECK(static_cast<double>(adaptive.rays.light) ==
        Approx(static_cast<double>(uniform.rays.light)).epsilon(0.02));
}

// One sample everywhere must be finished, and the light paths it needs. No more of them are begun.
TEST_CASE("time that is up at once leaves the light paths of one sample") {
  Scene scene = glass();
  scene.settings.seconds = 1e-9;
  const Rendering r = test::render_scene(scene, false);
  CHECK(r.film.light_passes() == 1.0);
  CHECK(r.film.samples(0, 0) == 1);
}

// Photon maps are shared by pixels. With other light paths the maps are other maps.
TEST_CASE("light paths do not decide where samples go") {
  Scene scene = glass();
  const Film few = render_with(scene, 32).film;
  scene.settings.light_paths = 4.0;
  const Film many = render_with(scene, 32).film;
  bool differs = false;
  for_each_pixel(few.window(), [&](int x, int y) {
    REQUIRE(few.samples(x, y) == many.samples(x, y));
    differs |= few.mean(*few.find(kBeauty), x, y, 1) != many.mean(*many.find(kBeauty), x, y, 1);
  });
  CHECK(differs); // the camera's samples see them
  const SampleCounts counts = sample_counts(few);
  CHECK(counts.most > 2 * counts.least);
}

TEST_CASE("a crop of a scene with light paths has the pixels of the whole") {
  Scene scene = glass();
  scene.settings.adaptive = AdaptiveSampling::off;
  const Film whole = render_with(scene, 24).film;
  scene.settings.crop = PixelWindow{11, 5, 30, 20};
  const Film crop = render_with(scene, 24).film;
  for_each_pixel(crop.window(), [&](int x, int y) {
    const Xyz a = crop.color(x, y), b = whole.color(x, y);
    REQUIRE(a.x == b.x);
    REQUIRE(a.y == b.y);
    REQUIRE(a.z == b.z);
  });
}

TEST_CASE("time that is never up leaves adaptive sampling what it is") {
  Scene scene = ball();
  const Rendering plain = render_with(scene, 64);
  scene.settings.seconds = 1e9;
  CHECK(test::same_pixels(render_with(scene, 64).film, plain.film));
}

TEST_CASE("progress with adaptive sampling grows to 1") {
  Scene scene = ball();
  scene.settings.samples_per_pixel = 48;
  const Plan plan = make_plan(scene, scene.settings);
  const World world(scene.shapes, farthest_coordinate(scene));
  double last = 0.0;
  const auto tell = [&](const RenderProgress& p) {
    CHECK(p.fraction >= last);
    CHECK(p.fraction <= 1.0);
    last = p.fraction;
  };
  CHECK(render(scene, plan, world, {}, {.progress = tell}).complete);
  CHECK(last == 1.0);
}

// 256 lights of 1/190 of a pixel on black. Their part of what the camera sees is known, and a
// sample meets a light with just this chance. A pixel has at least a quarter of the mean number of
// samples, which bounds the variance.
TEST_CASE("tiny lights keep their light, with adaptive sampling and to a noise target") {
  Scene scene = test::scene_from(
      "eye 0 0 10 lookAt 0 0 0 fieldOfView 20 imageSize 64 64 bands 5 integrator path\n"
      "defaultMaterials diffuse 0 0 0 ambient 0 0 0 emissive E 50\n"
      "def one { push scale 0.002 0.002 1 square pop translate 0.2071 0.0133 0 }\n"
      "def four { use one use one use one use one }\n"
      "def row { push use four use four use four use four pop translate -0.0117 0.2033 0 }\n"
      "def block { use row use row use row use row }\n"
      "translate -1.5 -1.7 0 use block use block use block use block\n");
  const double width = 20.0 * std::tan(10.0 * std::numbers::pi / 180.0);
  const double chance = 256.0 * 0.004 * 0.004 / (width * width);
  const auto mean_of = [&](int films) {
    double sum = 0.0;
    const double pixels = scene.settings.width * scene.settings.height;
    for (int i = 0; i < films; ++i) {
      scene.settings.seed = static_cast<std::uint64_t>(i) + 1;
      const Film film = test::render_scene(scene, false).film;
      for_each_pixel(film.window(), [&](int x, int y) { sum += film.color(x, y).y / pixels; });
    }
    return sum / films;
  };
  for (const int samples : {16, 64}) {
    scene.settings.adaptive = AdaptiveSampling::on;
    scene.settings.samples_per_pixel = samples;
    const int films = 512 / samples;
    const double least_hits = chance * films * 64 * 64 * samples / 4.0;
    CHECK(mean_of(films) == Approx(50.0 * chance).epsilon(4.5 / std::sqrt(least_hits)));
  }
  scene.settings.adaptive = AdaptiveSampling::off;
  // Four times the pixels: lights of a fiftieth of a pixel, a few in each tile. Tiles of which none
  // of the first 64 samples met a light stay black, with less than 1 % of the light. The error of
  // a film is 0.05 / sqrt(64 tiles) = 0.63 %.
  scene.settings.width = scene.settings.height = 128;
  scene.settings.noise = 0.05;
  scene.settings.samples_per_pixel = 512;
  CHECK(mean_of(1) == Approx(50.0 * chance).epsilon(0.01 + 4.5 * 0.0063));
}
