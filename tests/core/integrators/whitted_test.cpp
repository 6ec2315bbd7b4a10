#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/render_text.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180.0;

const std::string kLibrary = "lights \"" ABBE_SOURCE_DIR "/scenes/lights.filter\"\n";

/// What a single narrow pixel sees; the scene says from where. Bands are kept.
Film look(const Scene& scene) {
  Rendering r = test::render_scene(scene, true);
  CHECK(r.film.refused().not_finite == 0);
  CHECK(r.film.refused().negative == 0);
  return std::move(r.film);
}

Scene narrow(const std::string& text) {
  return test::scene_from(
      kLibrary + "fieldOfView 0.0001 imageSize 1 1 samples 1 jitter off exact on\n" + text);
}

/// Radiance in the band of 550 nm.
double seen(const std::string& text) {
  return look(narrow(text)).radiance(0, 0, 34);
}

constexpr double band_nm(int b) {
  return 380.0 + 5.0 * b;
}

} // namespace

// Radiance of a diffuse surface in the irradiance E = I / d^2 at normal incidence: rho E / pi.
TEST_CASE("a diffuse square lit head-on has the radiance rho I / (pi d^2) in every band") {
  const Scene scene =
      narrow("eye 3 0 4 lookAt 0 0 0 falloff square intensity 7 light 2a 0 0 2.5 1\n"
             "defaultMaterials ambient 0 0 0 diffuse 0.8 0.3 0.1 square");
  const Film film = look(scene);
  for (int b = 0; b < 81; ++b) {
    const double intensity = scene.lights[0].spectrum.at(band_nm(b));
    const double rho = scene.materials[0].diffuse.at(band_nm(b));
    CHECK(film.radiance(0, 0, b) == Approx(rho * intensity / (kPi * 2.5 * 2.5)).epsilon(1e-5));
  }
}

TEST_CASE("Hill's light makes rho times its value, times the cosine, at any distance") {
  const std::string square = "defaultMaterials ambient 0 0 0 diffuse 0.5 0.5 0.5 square";
  for (const double d : {1.0, 1000.0}) {
    const std::string lamp = "eye 3 0 4 lookAt 0 0 0 intensity 0.6 light E 0 0 ";
    CHECK(seen(lamp + std::to_string(d) + " 1 " + square) == Approx(0.5 * 0.6).epsilon(1e-4));
  }
  // from 60 degrees, near and parallel
  CHECK(seen("eye 3 0 4 lookAt 0 0 0 light E 0 1.7320508 1 1 " + square) ==
        Approx(0.25).epsilon(1e-4));
  CHECK(seen("eye 3 0 4 lookAt 0 0 0 light E 0 1.7320508 1 0 " + square) ==
        Approx(0.25).epsilon(1e-4));
}

TEST_CASE("lights add up, and none shines through the surface it is behind") {
  const std::string square = " defaultMaterials ambient 0 0 0 diffuse 0.5 0.5 0.5 square";
  CHECK(seen("eye 0 0 4 lookAt 0 0 0 light E 0 0 9 1 light E 0 0 5 1" + square) ==
        Approx(1.0).epsilon(1e-4));
  CHECK(seen("eye 0 0 4 lookAt 0 0 0 light E 0 0 -5 1" + square) == 0.0);
  CHECK(seen("eye 0 0 -4 lookAt 0 0 0 light E 0 0 -5 1" + square) == Approx(0.5).epsilon(1e-4));
}

// Blinn: the half vector of eye and light, at 60 and -20 degrees from the normal, is at 20 degrees,
// so the highlight is ks cos(20 deg)^e, without the cosine of the light.
TEST_CASE("the highlight is the cosine of the half vector to the exponent's power") {
  const auto from = [](double angle_deg) {
    const double a = angle_deg * kDegree;
    return std::to_string(std::sin(a)) + " 0 " + std::to_string(std::cos(a)) + " ";
  };
  const std::string surface = "defaultMaterials ambient 0 0 0 diffuse 0 0 0 specular 0.7 0.7 0.7\n";
  for (const double exponent : {1.0, 12.8, 300.0}) {
    const std::string shiny = surface + "specularExponent " + std::to_string(exponent) + " square";
    CHECK(seen("eye " + from(-20.0) + "lookAt 0 0 0 light E " + from(60.0) + "0 " + shiny) ==
          Approx(0.7 * std::pow(std::cos(20.0 * kDegree), exponent)).epsilon(1e-3));
    CHECK(seen("eye " + from(-40.0) + "lookAt 0 0 0 light E " + from(40.0) + "0 " + shiny) ==
          Approx(0.7).epsilon(1e-3)); // the mirror direction
  }
}

TEST_CASE("a surface shows its emission, and its ambient part times the ambient light") {
  const Scene scene = narrow("eye 0 0 4 lookAt 0 0 0 globalAmbient D65 0.3\n"
                             "defaultMaterials ambient 0.6 0.2 0.1 emissive 0.2 0.4 0.1 square");
  const Film film = look(scene);
  for (int b = 0; b < 81; ++b) {
    const Material& m = scene.materials[0];
    const double nm = band_nm(b);
    CHECK(film.radiance(0, 0, b) ==
          Approx(m.emission.at(nm) + m.ambient.at(nm) * scene.global_ambient.at(nm)).epsilon(1e-5));
  }
}

TEST_CASE("a mirror shows what is before it, times its reflectivity") {
  // From above at 45 degrees onto the mirror; beyond it a wall that glows.
  CHECK(seen("eye -5 0 5 lookAt 0 0 0 background E 1 defaultMaterials ambient 0 0 0 diffuse 0 0 0\n"
             "reflectivity 0.8 square") == Approx(0.8).epsilon(1e-4));
  const Scene scene =
      narrow("eye -5 0 5 lookAt 0 0 0\n"
             "defaultMaterials ambient 0 0 0 diffuse 0 0 0 reflectivity 0.8 square\n"
             "defaultMaterials emissive 0.9 0.5 0.2 translate 5 0 5 rotate 90 0 1 0\n"
             "square");
  const Film film = look(scene);
  for (int b = 0; b < 81; ++b)
    CHECK(film.radiance(0, 0, b) ==
          Approx(0.8 * scene.materials[1].emission.at(band_nm(b))).epsilon(1e-5));
}

namespace {

/// Between two parallel mirrors that glow: 1 + r + r^2 + ..., as far as the path goes.
double between_mirrors(const std::string& settings) {
  const Scene scene = narrow("eye 0 0 1 lookAt 0 0 0 defaultMaterials ambient 0 0 0 diffuse 0 0 0\n"
                             "emissive 1 1 1 reflectivity 0.5 square translate 0 0 2 square\n" +
                             settings);
  return look(scene).radiance(0, 0, 34) / scene.materials[0].emission.at(550.0);
}

} // namespace

TEST_CASE("the depth is how often a path is reflected") {
  CHECK(between_mirrors("maxRecursionDepth 0") == Approx(1.0).epsilon(1e-6));
  CHECK(between_mirrors("maxRecursionDepth 1") == Approx(1.5).epsilon(1e-6));
  CHECK(between_mirrors("maxRecursionDepth 3") == Approx(1.875).epsilon(1e-6));
  CHECK(between_mirrors("maxRecursionDepth 60 minThroughput 1e-9") == Approx(2.0).epsilon(1e-6));
}

// Of 1 + r + r^2 + ... what lies above the threshold is there in each sample; the rest is there in
// the mean. A path that goes on at random reaches k mirrors more with the chance 2^-k and gathers
// the threshold at each, so that the rest has a mean of twice the threshold at most, and a variance
// of 2 threshold^2.
TEST_CASE("branches that carry less than minThroughput are followed at random: no light is lost") {
  constexpr int kSamples = 1 << 14;
  for (const double least : {0.1, 0.125, 1.0}) {
    const std::string settings = "samples 1 minThroughput " + std::to_string(least);
    const double one = between_mirrors(settings);
    CHECK(one >= (least > 0.5 ? 1.0 : 1.75) * (1.0 - 1e-6));
    const double mean = between_mirrors(settings + " samples " + std::to_string(kSamples));
    CHECK(mean == Approx(2.0).margin(4.0 * least * std::sqrt(2.0 / kSamples)));
  }
  CHECK(between_mirrors("minThroughput 0.25 maxRecursionDepth 2") == Approx(1.75).epsilon(1e-6));
}

TEST_CASE("a branch is followed for sure for its brightest band") {
  // Reflectance below 0.1 in the blue, above 0.9 in the red: the red keeps the blue alive.
  const std::string mirror = "eye -5 0 5 lookAt 0 0 0 background E 1 minThroughput 0.5 "
                             "materials \"" ABBE_SOURCE_DIR "/scenes/all.mtl\" "
                             "UseMaterial StrongOrangeYellow transparency 0 square";
  const Scene scene = narrow(mirror);
  Scene bright = scene;
  bright.materials[0].reflectivity = Curve::table({500.0, 600.0}, {0.05, 0.95});
  bright.materials[0].transparency = bright.materials[0].diffuse = bright.materials[0].specular =
      Curve();
  const Film film = look(bright);
  CHECK(film.radiance(0, 0, 0) == Approx(0.05).epsilon(1e-4));
  CHECK(film.radiance(0, 0, 80) == Approx(0.95).epsilon(1e-4));
}

// A mirror of r = 1/2 below a least of m sends on the weight m with the chance r / m, so that
// k more mirrors follow with the chance (r / m)^k (1 - r / m). The sum of the powers of m over them
// has the mean 1 / (1 - r), and the variance (1 + r) / ((1 - r) (1 - m r)) - 1 / (1 - r)^2.
TEST_CASE("surfaces that reflect less than minReflectivity reflect at random: no light is lost") {
  constexpr int kSamples = 1 << 14;
  CHECK(between_mirrors("minReflectivity 0.5") > 1.99);
  // A single sample is 1, 1.6, 1.96, 2.176, ... then, and never 2.
  CHECK(between_mirrors("samples 1 minReflectivity 0.6 minThroughput 0") !=
        Approx(2.0).epsilon(1e-3));
  for (const double least : {0.6, 0.9}) {
    const double mean = between_mirrors("minThroughput 0 minReflectivity " + std::to_string(least) +
                                        " samples " + std::to_string(kSamples));
    const double variance = 1.5 / (0.5 * (1.0 - 0.5 * least)) - 4.0;
    CHECK(mean == Approx(2.0).margin(4.0 * std::sqrt(variance / kSamples)));
  }
}

// A slab without Fresnel sends back r + t^2 / (1 - r), as above. With t = 0.3 below a least of 0.6
// each passage brings 0.6 every other time. What is inside brings I = X_0 + r X_1 + r^2 X_2 + ...,
// of mean 0.6 and variance 0.09 / (1 - r^2) = 0.12, and what enters Y I: its variance is
// E Y^2 E I^2 - 0.18^2 = 0.18 (0.12 + 0.36) - 0.0324 = 0.054.
TEST_CASE("surfaces that let through less than minTransparency do so at random: no light is lost") {
  constexpr double r = 0.5, t = 0.3;
  const std::string slab = "eye 0 0 5 lookAt 0 0 0 background E 1 maxRecursionDepth 100\n"
                           "minThroughput 0 defaultMaterials ambient 0 0 0 diffuse 0 0 0\n"
                           "reflectivity 0.5 transparency 0.3 fresnel off speedOfLight 1.5 cube\n";
  CHECK(seen(slab) == Approx(r + t * t / (1.0 - r)).epsilon(1e-4));
  CHECK(seen(slab + "minTransparency 0.6 samples 16384") ==
        Approx(r + t * t / (1.0 - r)).margin(4.0 * std::sqrt(0.054 / 16384.0)));
}

// Without Fresnel the slab's sides reflect r and pass t, whatever the angle. All light that the
// camera sees comes from radiance 1: r + t (1 + r + r^2 + ...) t = r + t^2 / (1 - r).
TEST_CASE("with Fresnel off a slab's constants make a geometric series") {
  CHECK(seen("eye 0 0 5 lookAt 0 0 0 background E 1 maxRecursionDepth 100 minThroughput 0\n"
             "defaultMaterials ambient 0 0 0 diffuse 0 0 0 reflectivity 0.2 transparency 0.7\n"
             "fresnel off speedOfLight 1.5 cube") == Approx(0.2 + 0.49 / 0.8).epsilon(1e-4));
}

TEST_CASE("where a ray meets nothing it shows the background") {
  const Scene scene = narrow("background D65 0.4");
  const Film film = look(scene);
  for (int b = 0; b < 81; ++b)
    CHECK(film.radiance(0, 0, b) == Approx(scene.background.at(band_nm(b))).epsilon(1e-5));
  CHECK(film.alpha(0, 0) == 1.0);
}
