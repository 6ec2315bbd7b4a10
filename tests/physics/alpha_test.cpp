// Alpha: A = 1 - T, where T is the share of the light behind the scene that shows in the picture.

#include "spectral/color.h"
#include "spectral/illuminant.h"
#include "spectral/observer.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Film film_of(const std::string& text) {
  return std::move(test::render_scene(test::scene_from(text), false).film);
}

/// A view so narrow that all its rays are the same, straight along -z unless the text has an eye of
/// its own.
const std::string kNarrow = "filter box imageSize 1 1 fieldOfView 0.0001 minThroughput 1e-12 "
                            "eye 0 0 50 lookAt 0 0 0 ";
double alpha_of(const std::string& text) {
  return film_of(kNarrow + text).alpha(0, 0);
}

const std::string kGlass = "defaultMaterials speedOfLight 1.5 transparency 1 reflectivity 1 "
                           "ambient 0 0 0 diffuse 0 0 0 ";
const std::string kMirror = "defaultMaterials reflectivity 1 ambient 0 0 0 diffuse 0 0 0 ";
/// Both integrators, with samples enough for what they choose at random.
const std::string kIntegrators[] = {"integrator whitted samples 4 ",
                                    "integrator path samples 4096 "};

} // namespace

TEST_CASE("rain lets through what Beer and Lambert's law leaves") {
  for (const std::string integrator : {"integrator whitted ", "integrator path "}) {
    CAPTURE(integrator);
    CHECK(alpha_of(integrator + "samples 4 drops 0.25 scale 1 1 2 cube") ==
          Approx(1.0 - std::exp(-0.25 * 4.0)).epsilon(1e-4));
    CHECK(alpha_of(integrator + "samples 4") == 0.0);
  }
}

// The faces of a slab send light to and fro: with the reflectance R = ((n - 1) / (n + 1))^2 = 0.04
// of one it lets (1 - R)^2 (1 + R^2 + R^4 ...) = (1 - R) / (1 + R) through.
TEST_CASE("a slab of glass lets through the sum of all that its faces send to and fro") {
  const double let_through = (1.0 - 0.04) / (1.0 + 0.04);
  for (const std::string& integrator : kIntegrators) {
    CAPTURE(integrator);
    for (const std::string& slab :
         {kGlass + "cube", kGlass + "scale 1 1 0.01 cube", std::string("thinGlass 4 1.5 square")})
      CHECK(1.0 - alpha_of(integrator + slab) == Approx(let_through).epsilon(0.004));
  }
  CHECK(1.0 - alpha_of("exact on samples 1 " + kGlass + "cube") ==
        Approx(let_through).epsilon(1e-6));
}

TEST_CASE("what a slab reflects of the sky stays in a picture without sky, and is opaque") {
  const double reflected = 2.0 * 0.04 / (1.0 + 0.04);
  const Film film =
      film_of(kNarrow + "sky transparent background E 1 samples 1 exact on " + kGlass + "cube");
  CHECK(film.alpha(0, 0) == Approx(reflected).epsilon(1e-5));
  CHECK(film.color(0, 0).y == Approx(reflected).epsilon(1e-5));
}

// A prism of 60 degrees, at minimum deviation: both faces are met at 50 degrees, and the ray is
// bent by 40 degrees, with n = sin 50 / sin 30. The depth keeps out what the faces reflect inside.
TEST_CASE("a prism that bends by 40 degrees lets through what its two faces do") {
  const double cos_i = std::cos(50.0 * kDegree), cos_t = std::cos(30.0 * kDegree);
  const double n = std::sin(50.0 * kDegree) / std::sin(30.0 * kDegree);
  const double s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  const double p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
  const double let_through = std::pow(1.0 - 0.5 * (s * s + p * p), 2);
  // The left face's normal, and up to the apex; the eye looks at the middle of the face.
  const double h = std::numbers::sqrt3 / 2.0;
  const dvec3 outward(-h, 0.0, -0.5), along(0.5, 0.0, -h);
  const dvec3 to_eye = cos_i * outward - std::sin(50.0 * kDegree) * along;
  const dvec3 eye = outward + 50.0 * to_eye;
  const std::string scene = fmt::format("eye {} 0 {} lookAt {} 0 {} maxRecursionDepth 2 {} "
                                        "speedOfLight {:.17g} prism",
                                        eye.x, eye.z, outward.x, outward.z, kGlass, n);
  for (const std::string& integrator : kIntegrators) {
    CAPTURE(integrator);
    CHECK(1.0 - alpha_of(integrator + scene) == Approx(let_through).epsilon(0.01));
  }
}

TEST_CASE("what reflects the sky is opaque, at whatever angle") {
  for (const std::string& integrator : kIntegrators)
    for (const std::string sky : {"sky visible ", "sky transparent "})
      for (const int tilt : {0, 60, 88}) { // 60 and 88: within 90 degrees of the camera's ray
        CAPTURE(integrator, sky, tilt);
        const std::string turn = fmt::format("rotate {} 1 0 0 ", tilt);
        const std::string lit = integrator + sky + "background E 1 ";
        const Film mirror = film_of(kNarrow + lit + kMirror + turn + "square");
        CHECK(mirror.alpha(0, 0) == 1.0);
        CHECK(mirror.color(0, 0).y == Approx(1.0).epsilon(1e-5));
        const Film matt = film_of(kNarrow + lit + "defaultMaterials ambient 0 0 0 diffuse 1 1 1 " +
                                  turn + "square");
        CHECK(matt.alpha(0, 0) == 1.0);
      }
}

TEST_CASE("the sky is a part of the picture, or it is black and clear") {
  const std::string lit = "samples 4 background E 1 ";
  const Film visible = film_of(kNarrow + lit);
  CHECK(visible.alpha(0, 0) == 1.0);
  CHECK(visible.color(0, 0).y == Approx(1.0).epsilon(1e-6));
  const Film transparent = film_of(kNarrow + lit + "sky transparent");
  CHECK(transparent.alpha(0, 0) == 0.0);
  CHECK(transparent.color(0, 0) == Xyz{0.0, 0.0, 0.0});
}

TEST_CASE("in a dark sky only the disc of the sun is a part of the picture") {
  for (const bool transparent : {false, true})
    for (const double degrees : {0.0, 5.0}) {
      const Film film =
          film_of(fmt::format("{} samples 4 sky {} sunRadius 2 sun {:.17g} 0 {:.17g}", kNarrow,
                              transparent ? "transparent" : "visible", std::sin(degrees * kDegree),
                              -std::cos(degrees * kDegree)));
      const bool shows = degrees == 0.0 && !transparent;
      CHECK(film.alpha(0, 0) == (shows ? 1.0 : 0.0));
      CHECK((film.color(0, 0).y > 0.0) == shows);
    }
}

// Each band keeps exp(-a 2 mm) of what goes to and fro once: (1 - R)^2 e / (1 - R^2 e^2).
TEST_CASE("coloured glass tints what lies behind it by Beer and Lambert's law") {
  const Film film = film_of(kNarrow + "samples 1 exact on jitter off " + kGlass +
                            "absorptionTable 2 400 2 700 0 cube");
  Scene scene = test::scene_from(kNarrow + "samples 1 exact on jitter off " + kGlass +
                                 "absorptionTable 2 400 2 700 0 cube");
  scene.settings.layers.add(ExtraLayer::transmittance);
  const Film tinted = std::move(test::render_scene(scene, false).film);
  const auto weights = band_weights(BandGrid(81), *find_illuminant("D65"));
  Xyz expected{0.0, 0.0, 0.0}, clear{0.0, 0.0, 0.0};
  for (int b = 0; b < 81; ++b) {
    const double nm = 380.0 + 5.0 * b;
    const double absorption = std::clamp((700.0 - nm) / 150.0, 0.0, 2.0);
    const double e = std::exp(-2.0 * absorption), r = 0.04;
    expected +=
        (1.0 - r) * (1.0 - r) * e / (1.0 - r * r * e * e) * weights[static_cast<std::size_t>(b)];
    clear += weights[static_cast<std::size_t>(b)];
  }
  const LayerId layer = *tinted.find(kTransmittance);
  const Xyz white = to_xyz(kSrgbWhite, 1.0);
  CHECK(tinted.mean(layer, 0, 0, 0) == Approx(white.x * expected.x / clear.x).epsilon(1e-4));
  CHECK(tinted.mean(layer, 0, 0, 1) == Approx(expected.y / clear.y).epsilon(1e-4));
  CHECK(tinted.mean(layer, 0, 0, 2) == Approx(white.z * expected.z / clear.z).epsilon(1e-4));
  CHECK(1.0 - film.alpha(0, 0) == Approx(expected.y / clear.y).epsilon(1e-4));
  CHECK(film.alpha(0, 0) == tinted.alpha(0, 0)); // the layer changes nothing else
  CHECK_FALSE(film.find(kTransmittance));
}

TEST_CASE("light of few bands, or of none, is no hindrance") {
  const double let_through = (1.0 - 0.04) / (1.0 + 0.04);
  const std::string slab = "samples 1 exact on " + kGlass + "cube ";
  for (const std::string light : {"", "light sodium 0 0 50 1 ", "light HP1 0 0 50 1 "}) {
    CAPTURE(light);
    CHECK(1.0 - alpha_of(light + slab) == Approx(let_through).epsilon(1e-5));
    CHECK(alpha_of(light + "samples 4") == 0.0);
  }
}

namespace {

/// Everything that treats a sky in a way of its own: rain, a pane, coloured and rough glass, a
/// mirror and a matt floor.
const std::string kManyThings =
    "imageSize 12 12 eye 0 1 9 lookAt 0 0 0 fieldOfView 40 bands 27 "
    "push translate -2 1 0 drops 0.4 cube pop "
    "push translate 2 1.2 1 rotate 30 0 1 0 thinGlass 4 1.5 square pop " +
    kGlass +
    "push translate 0.2 1 0 scale 0.8 0.8 0.8 absorptionTable 2 400 1 700 0 sphere pop "
    "push translate -0.5 -0.2 2 roughness 0.4 scale 0.8 0.8 0.1 cube pop " +
    "defaultMaterials ambient 0 0 0 reflectivity 0.8 diffuse 0 0 0 "
    "push translate 2.5 -0.5 -1 rotate 20 0 1 0 square pop "
    "defaultMaterials ambient 0 0 0 diffuse 0.7 0.5 0.2 "
    "push translate 0 -1 0 rotate -90 1 0 0 scale 4 4 1 square pop ";

struct Pair {
  Film visible, transparent;
};

Pair both(const std::string& text, const std::optional<Environment>& environment = {}) {
  const auto film = [&](Sky sky) {
    Scene scene = test::scene_from(text + kManyThings);
    scene.environment = environment;
    scene.settings.sky = sky;
    scene.settings.layers.add(ExtraLayer::transmittance);
    return std::move(test::render_scene(scene, false).film);
  };
  return {film(Sky::visible), film(Sky::transparent)};
}

} // namespace

// The same paths are followed, and each either passes to the sky or does not.
TEST_CASE("a picture without its sky, laid over this sky, is the picture with it") {
  for (const std::string integrator :
       {"integrator whitted samples 8 ", "integrator path samples 32 "}) {
    CAPTURE(integrator);
    const auto [visible, transparent] = both(integrator + "background D65 0.5 ");
    const LayerId layer = *transparent.find(kTransmittance);
    const Xyz white = to_xyz(kSrgbWhite, 0.5);
    double seen = 0.0;
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const Xyz over = transparent.color(x, y) + Xyz{0.5 * transparent.mean(layer, x, y, 0),
                                                       0.5 * transparent.mean(layer, x, y, 1),
                                                       0.5 * transparent.mean(layer, x, y, 2)};
        const Xyz whole = visible.color(x, y);
        CHECK(over.x == Approx(whole.x).epsilon(1e-3).margin(1e-4));
        CHECK(over.y == Approx(whole.y).epsilon(1e-4).margin(1e-5));
        CHECK(over.z == Approx(whole.z).epsilon(1e-3).margin(1e-4));
        CHECK(transparent.color(x, y).y + (1.0 - transparent.alpha(x, y)) * white.y ==
              Approx(whole.y).epsilon(1e-4).margin(1e-5));
        CHECK(visible.alpha(x, y) == 1.0);
        seen += 1.0 - transparent.alpha(x, y);
      }
    CHECK(seen > 10.0);
    CHECK(seen < 130.0);
  }
}

// An environment is aimed at too, so that paths through rough glass see it in two ways.
TEST_CASE("the same for an environment that is sampled as a light") {
  Environment grey;
  grey.width = 8;
  grey.height = 4;
  grey.light = *find_illuminant("D65");
  grey.rgb.assign(3 * 32, 0.5f);
  const auto [visible, transparent] = both("integrator path samples 1024 ", grey);
  double whole = 0.0, over = 0.0;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 12; ++x) {
      whole += visible.color(x, y).y;
      over += transparent.color(x, y).y + 0.5 * (1.0 - transparent.alpha(x, y));
    }
  CHECK(over == Approx(whole).epsilon(2e-3));
}
