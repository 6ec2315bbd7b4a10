#include "core/film/lost_light.h"
#include "core/image/metadata.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <chrono>
#include <cmath>
#include <thread>

using namespace abbe;

namespace {

const std::string kCard = "eye 0 0 50 lookAt 0 0 0 fieldOfView 2 imageSize 8 8 bands 5\n"
                          "caustics off samples 256\n"
                          "defaultMaterials ambient 0 0 0 diffuse 0 0 0 emissive E 1\n"
                          "push translate 0 0 -60 scale 10 10 1 square pop emissive 0 0 0\n";

std::string eight_panes() {
  std::string text = "speedOfLight 1.5 transparency 1 reflectivity 1\n";
  for (int i = 0; i < 8; ++i)
    text += "push translate 0 0 " + std::to_string(i) + " scale 8 8 0.1 cube pop\n";
  return text;
}

void check_lost(const Rendering& r, double share, double largest_error) {
  const auto lost = lost_share(r.film);
  REQUIRE(lost);
  CHECK(lost->error < largest_error);
  CHECK(lost->share == Approx(share).margin(4.0 * lost->error));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

// With R = 0.04 all light through 16 surfaces is (1 - R) / (1 + 15 R) = 0.6. A path of 16 surfaces
// goes straight: (1 - R)^16. With 18 one more pair of reflections fits in: of the 16 surfaces any
// two that follow one another can make it.
TEST_CASE("what a depth limit takes is estimated") {
  const double straight = std::pow(0.96, 16.0), twice = straight * (1.0 + 15.0 * 0.04 * 0.04);
  for (const char* integrator : {"whitted", "path"}) {
    INFO(integrator);
    const auto render = [&](const std::string& depth) {
      return test::render_scene(test::scene_from(kCard + "integrator " + integrator +
                                                 " maxRecursionDepth " + depth + "\n" +
                                                 eight_panes()),
                                true);
    };
    const Rendering limited = render("16");
    check_lost(limited, 1.0 - straight / 0.6, 0.03);
    check_lost(render("18"), 1.0 - twice / 0.6, 0.03);
    if (integrator == std::string("whitted")) // nothing is left to chance there
      for_each_pixel(limited.film.window(), [&](int x, int y) {
        CHECK(limited.film.radiance(x, y, 2) == Approx(straight).epsilon(1e-5));
      });
    const Rendering unlimited = render("1000000");
    CHECK_FALSE(lost_share(unlimited.film));
    CHECK(lost_metadata(unlimited.film).empty());
    CHECK(lost_metadata(limited.film).size() == 1);
  }
}

// The card behind panes of thin glass, which count as no surfaces: what they reflect is lost. Each
// pane reflects 2 R / (1 + R), and N of them let through 1 / (1 + N r / (1 - r)).
TEST_CASE("what a depth limit takes between thin panes is estimated") {
  const double r = 0.08 / 1.04;
  const double all = 1.0 / (1.0 + 6.0 * r / (1.0 - r)), straight = std::pow(1.0 - r, 6.0);
  std::string panes = "thinGlass 1 1.5\n";
  for (int i = 0; i < 6; ++i)
    panes += "push translate 0 0 " + std::to_string(i) + " scale 8 8 1 square pop\n";
  for (const char* integrator : {"whitted", "path"}) {
    INFO(integrator);
    check_lost(test::render_scene(test::scene_from(kCard + "integrator " + integrator +
                                                   " maxRecursionDepth 0\n" + panes),
                                  true),
               1.0 - straight / all, 0.02);
  }
}

TEST_CASE("what a limit takes does not depend on threads") {
  for (const char* integrator : {"whitted", "path"}) {
    Scene scene = test::scene_from("imageSize 24 24 samples 8 background E 1 maxRecursionDepth 2\n"
                                   "eye 0 0 6 lookAt 0 0 0 glass N-BK7 sphere integrator " +
                                   std::string(integrator));
    const auto shares = [&](int threads) {
      scene.settings.threads = threads;
      const auto lost = lost_share(test::render_scene(scene, false).film);
      REQUIRE(lost);
      return std::pair(lost->share, lost->error);
    };
    CHECK(shares(1).first > 0.0);
    CHECK(shares(1) == shares(4));
  }
}

// The camera sees the wall in a mirror, and the lamp lights it by another: three surfaces. What
// each side has met is within its limit, but not both together.
TEST_CASE("a depth limit counts the surfaces of the camera's and of the light's path together") {
  const std::string scene =
      "integrator path caustics on imageSize 4 4 samples 64 lightPaths 64 bands 5\n"
      "eye 0 0 4 lookAt 0 0 0 fieldOfView 4 background E 0\n"
      "falloff square light E 0.3 0 3 1\n"
      "defaultMaterials ambient 0 0 0 diffuse 0 0 0 specular 0 0 0 reflectivity 1 fresnel off\n"
      "push scale 3 3 1 square pop\n" // the mirror at z = 0
      "reflectivity 0 diffuse 0.5 0.5 0.5\n"
      "push translate 0 0 6 rotate 180 0 1 0 scale 3 3 1 square pop\n"; // the wall behind the eye
  const auto render = [&](const std::string& depth) {
    return test::render_scene(test::scene_from("maxRecursionDepth " + depth + "\n" + scene), false);
  };
  const Rendering all = render("1000000"), three = render("3"), two = render("2");
  const auto mean = [](const Rendering& r) {
    double sum = 0.0;
    for_each_pixel(r.film.window(), [&](int x, int y) { sum += r.film.color(x, y).y; });
    return sum;
  };
  // Directly lit, and by the mirror; the wall and the mirror send light back and forth for ever.
  CHECK(mean(two) > 0.0);
  CHECK(mean(three) > 1.05 * mean(two));
  const auto lost = lost_share(two.film);
  REQUIRE(lost);
  CHECK(lost->share == Approx(1.0 - mean(two) / mean(all)).margin(4.0 * lost->error + 0.01));
}

// Between perfect mirrors such a path has millions of surfaces.
TEST_CASE("a rendering stops within a path") {
  for (const char* integrator : {"whitted", "path"}) {
    Scene scene = test::scene_from("background E 1 eye 0.1 0.2 0.3 lookAt 0 0 -1 imageSize 1 1\n"
                                   "samples 1 minThroughput 1e-14 exact on bands 5 fresnel off\n"
                                   "reflectivity 1 ambient 0 0 0 diffuse 0 0 0 sphere integrator " +
                                   std::string(integrator));
    if (integrator == std::string("path")) scene.settings.samples_per_pixel = 1 << 20;
    const Plan plan = make_plan(scene, scene.settings);
    const World world(scene.shapes, farthest_coordinate(scene));
    std::atomic<bool> stop = false;
    const std::jthread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      stop = true;
    });
    const auto start = std::chrono::steady_clock::now();
    const Rendering r = render(scene, plan, world, {}, {.stop = &stop});
    CHECK_FALSE(r.complete);
    CHECK(seconds_since(start) < 1.5);
    CHECK(r.film.refused().not_finite == 0);
  }
}
