#include "spectral/color.h"
#include "spectral/illuminant.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// An image whose pixels depend on their row and column.
Environment picture(int width, int height, const std::function<LinearRgb(int, int)>& color) {
  Environment e;
  e.width = width;
  e.height = height;
  e.light = *find_illuminant("D65");
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const LinearRgb c = color(x, y);
      for (const double v : {c.r, c.g, c.b})
        e.rgb.push_back(static_cast<float>(v));
    }
  return e;
}

/// The middle of the image; the camera looks from (0, 0, 5) at the origin.
Xyz seen(const std::string& text, const std::optional<Environment>& environment, int samples) {
  Scene scene = test::scene_from("filter box fieldOfView 0.0001 imageSize 1 1 samples " +
                                 std::to_string(samples) + "\n" + text);
  scene.environment = environment;
  return test::render_scene(scene, false).film.color(0, 0);
}

void check_same(const Xyz& a, const Xyz& b, double epsilon) {
  CHECK(a.x == Approx(b.x).epsilon(epsilon));
  CHECK(a.y == Approx(b.y).epsilon(epsilon));
  CHECK(a.z == Approx(b.z).epsilon(epsilon));
}

const std::string kWhite = "ambient 0 0 0 diffuse 1 1 1 ";

} // namespace

TEST_CASE("an environment of one colour is the background of this colour") {
  const auto constant = picture(16, 8, [](int, int) { return LinearRgb{0.5, 2.0, 0.25}; });
  // The image's curve is read at the bands' middles, as materials are; the background is not.
  for (const auto& [bands, epsilon] :
       {std::pair("bands 81 ", 1e-3), std::pair("bands 27 ", 1.2e-2)})
    for (const std::string scene :
         {"integrator whitted", "integrator path", "integrator whitted glass SF11 sphere",
          "integrator path maxRecursionDepth 1 rotate 40 1 0 0 diffuse 0.9 0.5 0.1 square"}) {
      CAPTURE(bands, scene);
      const std::string steady = std::string(bands) + "maxFan 405 " + scene;
      check_same(seen(steady, constant, 512),
                 seen("background 0.5 2 0.25 " + steady, std::nullopt, 512), epsilon);
    }
}

// A white hemisphere above lights a surface tilted by b with pi (1 + cos b) / 2, one below with
// pi (1 - cos b) / 2. Between the rows at the horizon the image is a ramp, which changes this by
// second order in its width.
TEST_CASE("half a sky lights a tilted surface by its closed form") {
  const auto sky = picture(128, 64, [](int, int y) {
    const double v = y < 32 ? 1.0 : 0.0;
    return LinearRgb{v, v, v};
  });
  for (const double b : {90.0, 60.0, 30.0}) {
    // From +z, which is the horizon, the normal is turned up until it is b from +y.
    const std::string turned = "rotate " + std::to_string(b - 90.0) + " 1 0 0 square";
    const double expected = 0.5 * (1.0 + std::cos(b * kDegree));
    CHECK(seen("integrator path maxRecursionDepth 1 " + kWhite + turned, sky, 4096).y ==
          Approx(expected).epsilon(2e-3));
  }
}

// The same light by an image with one bright pixel, once by light samples and once by chance: both
// the directions of a rough mirror and the light samples find it.
TEST_CASE("a small bright spot is as bright whether it is aimed at or met") {
  const auto spot = picture(64, 32, [](int x, int y) {
    const double v = x == 20 && y == 8 ? 100.0 : 0.0; // elevation 48 degrees
    return LinearRgb{v, v, v};
  });
  // The pixel's bilinear tent has the solid angle of a pixel; its direction by the image's rule.
  const double row = 8.5 / 32.0 * std::numbers::pi,
               turn = (20.5 / 64.0 - 0.5) * 2.0 * std::numbers::pi;
  const dvec3 to_spot{std::sin(row) * std::sin(turn), std::cos(row),
                      -std::sin(row) * std::cos(turn)};
  const double solid_angle = std::sin(row) * std::pow(2.0 * std::numbers::pi / 64.0, 2);
  // The floor's normal is +y; the tent is narrow, so its cosine is that of the middle.
  const double expected = 100.0 * solid_angle * to_spot.y / std::numbers::pi;
  CHECK(seen("eye 0 5 1 lookAt 0 0 0 integrator path maxRecursionDepth 1 " + kWhite +
                 "rotate -90 1 0 0 square",
             spot, 4096)
            .y == Approx(expected).epsilon(1e-2));
}

TEST_CASE("one spectrum for all of an image keeps its luminance") {
  auto sky = picture(8, 4, [](int, int) { return LinearRgb{0.1, 0.7, 0.3}; });
  sky.has_colors = false;
  sky.light = *find_illuminant("A");
  const double y = luminance({0.1, 0.7, 0.3});
  for (const std::string bands : {"bands 81 ", "bands 9 "})
    check_same(seen(bands + "integrator whitted", sky, 1),
               seen(bands + "background A " + std::to_string(y), std::nullopt, 1), 1e-5);
}

TEST_CASE("an environment of a line's light has the line's colour") {
  auto sky = picture(8, 4, [](int, int) { return LinearRgb{1.0, 1.0, 1.0}; });
  sky.has_colors = false;
  sky.light = test::scene_from("background line(589.3)").background;
  check_same(seen("integrator path", sky, 1), seen("background line(589.3)", std::nullopt, 1),
             1e-5);
}

TEST_CASE("environment and background add up") {
  const auto sky = picture(8, 4, [](int, int) { return LinearRgb{0.5, 0.5, 0.5}; });
  CHECK(seen("background D65 0.25 integrator path", sky, 1).y == Approx(0.75).epsilon(1e-4));
}
