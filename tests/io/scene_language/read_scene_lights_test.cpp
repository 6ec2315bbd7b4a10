#include "tests/io/scene_language/read_scene_helpers.h"

#include "spectral/illuminant.h"
#include "spectral/radiator.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <numbers>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace

TEST_CASE("Hill's light is a point with a colour and no falloff") {
  const Scene scene = scene_of("light 1 2 3 0.5 0.25 2");
  REQUIRE(scene.lights.size() == 1);
  const Light& light = scene.lights[0];
  CHECK(std::get<PointLight>(light.kind).position == dvec3(1, 2, 3));
  CHECK(std::get<PointLight>(light.kind).falloff == Falloff::none);
  CHECK(light.spectrum == rgb_emission({0.5, 0.25, 2.0}));
}

TEST_CASE("the thesis's light is a point or comes from a direction") {
  const Scene scene = scene_of("light D65 1 2 3 1 light A 0 3 4 0");
  CHECK(scene.lights.at(0).name == "D65");
  CHECK(std::get<PointLight>(scene.lights.at(0).kind).position == dvec3(1, 2, 3));
  CHECK(scene.lights.at(0).spectrum == *find_illuminant("D65"));
  const dvec3 direction = std::get<DirectionalLight>(scene.lights.at(1).kind).direction;
  CHECK(glm::length(direction - dvec3(0, -0.6, -0.8)) < 1e-15);
}

TEST_CASE("a light whose name is a number is quoted") {
  CHECK(scene_of("light \"E\" 0 0 0 1").lights.at(0).name == "E");
  CHECK(
      scene_error("light \"85\" 0 0 0 1") ==
      "s.sdl:1:7: unknown light \"85\" (there is no lights.filter beside the scene, and no lights "
      "keyword; no such illuminant). D65 and A are always there");
}

TEST_CASE("a spotlight has an axis, a half-angle and a soft edge") {
  const Scene scene =
      scene_of("spotlight E 1 2 3 1 0 0 -5 20 softEdge 5 spotlight E 0 0 0 1 1 0 0 20");
  const auto& hard = std::get<SpotLight>(scene.lights.at(0).kind);
  CHECK(hard.position == dvec3(1, 2, 3));
  CHECK(hard.axis == dvec3(0, 0, -1));
  CHECK(hard.half_angle == Approx(20.0 * kDegree));
  CHECK(hard.full_angle == Approx(20.0 * kDegree));
  const auto& soft = std::get<SpotLight>(scene.lights.at(1).kind);
  CHECK(soft.half_angle == Approx(20.0 * kDegree));
  CHECK(soft.full_angle == Approx(15.0 * kDegree));
}

TEST_CASE("falloff and intensity hold for the lights that follow") {
  const Scene scene = scene_of("light E 0 0 0 1 falloff square intensity 3 light E 0 0 0 1\n"
                               "light E 0 1 0 0 light 0 0 0 1 1 1 falloff none light E 0 0 0 1");
  const auto falloff = [&](std::size_t i) {
    return std::get<PointLight>(scene.lights.at(i).kind).falloff;
  };
  CHECK(falloff(0) == Falloff::none);
  CHECK(scene.lights.at(0).spectrum.constant_value() == 1.0);
  CHECK(falloff(1) == Falloff::square);
  CHECK(scene.lights.at(1).spectrum.constant_value() == 3.0);
  CHECK(scene.lights.at(2).spectrum.constant_value() == 3.0);
  CHECK(falloff(3) == Falloff::square);
  CHECK(scene.lights.at(3).spectrum == rgb_emission({1.0, 1.0, 1.0}).scaled(3.0));
  CHECK(falloff(4) == Falloff::none);
}

TEST_CASE("lights stand where the current transform puts them") {
  const Scene scene = scene_of("translate 0 0 10 rotate 90 0 1 0 light 1 0 0 1 1 1\n"
                               "light E 1 0 0 1 light E 1 0 0 0 spotlight E 1 0 0 1 1 0 0 5");
  const dvec3 expected(0, 0, 9); // a quarter turn about y takes x to -z
  CHECK(glm::length(std::get<PointLight>(scene.lights.at(0).kind).position - expected) < 1e-14);
  CHECK(glm::length(std::get<PointLight>(scene.lights.at(1).kind).position - expected) < 1e-14);
  const dvec3 sun = std::get<DirectionalLight>(scene.lights.at(2).kind).direction;
  CHECK(glm::length(sun - dvec3(0, 0, 1)) < 1e-14);
  const auto& spot = std::get<SpotLight>(scene.lights.at(3).kind);
  CHECK(glm::length(spot.position - expected) < 1e-14);
  CHECK(glm::length(spot.axis - dvec3(0, 0, -1)) < 1e-14);
}

TEST_CASE("directions of any length are made unit") {
  const Scene scene = scene_of("light E 0 1e200 0 0 light E 0 1e-200 0 0\n"
                               "spotlight E 0 0 0 1 0 0 1e-300 5");
  for (const std::size_t i : {0U, 1U})
    CHECK(std::get<DirectionalLight>(scene.lights.at(i).kind).direction == dvec3(0, -1, 0));
  CHECK(std::get<SpotLight>(scene.lights.at(2).kind).axis == dvec3(0, 0, 1));
}

TEST_CASE("a sun comes from a direction, with the spectrum of the sun unless one is named") {
  const Scene scene = scene_of("sun 0 3 4 sunRadius 2 intensity 3 falloff square\n"
                               "sun 1 0 0 D65 sun 0 0 1 \"E\" sphere");
  const auto sun = [&](std::size_t i) { return std::get<SunLight>(scene.lights.at(i).kind); };
  CHECK(glm::length(sun(0).direction - dvec3(0, -0.6, -0.8)) < 1e-15);
  CHECK(sun(0).angular_radius == Approx(0.2665 * kDegree).epsilon(1e-15));
  CHECK(scene.lights.at(0).spectrum == blackbody(5778.0));
  CHECK(sun(1).direction == dvec3(-1, 0, 0));
  CHECK(sun(1).angular_radius == Approx(2.0 * kDegree).epsilon(1e-15));
  CHECK(scene.lights.at(1).spectrum == find_illuminant("D65")->scaled(3.0));
  CHECK(scene.lights.at(2).spectrum.constant_value() == 3.0);
  CHECK(scene.shapes.size() == 1);
}

TEST_CASE("errors of suns") {
  CHECK(scene_error("sun 0 0 0") ==
        "s.sdl:1:5: a sun in the direction 0 0 0 (x y z is the direction it comes from). Give a "
        "direction such as 0 1 0");
  CHECK(scene_error("sun 0 1 0 D66") ==
        "s.sdl:1:11: unknown light \"D66\" (there is no lights.filter beside the scene, and no "
        "lights keyword; no such illuminant). Did you mean D65?");
  CHECK(scene_error("sun 0 1 0 2") ==
        "s.sdl:1:11: \"2\" stands where a keyword should (the statement before it has all its "
        "arguments). Remove it, or check the statement before it");
  for (const std::string angle : {"0", "91"})
    CHECK(scene_error("sunRadius " + angle) ==
          "s.sdl:1:11: " + angle +
              " is out of range for sunRadius (it is half the angle of a sun's disc, in degrees). "
              "Give a number from 0.01 to 90");
}

TEST_CASE("errors of lights") {
  CHECK(scene_error("light D66 0 0 0 1") ==
        "s.sdl:1:7: unknown light \"D66\" (there is no lights.filter beside the scene, and no "
        "lights keyword; no such illuminant). Did you mean D65?");
  CHECK(scene_error("light D65 0 0 0 2") ==
        "s.sdl:1:17: \"2\" is no choice of light (light takes x y z r g b | NAME x y z LOCALITY). "
        "Give 1 or 0");
  CHECK(scene_error("light {") ==
        "s.sdl:1:7: \"{\" stands where the name of a light, or a position, should (light takes x y "
        "z r g b | NAME x y z LOCALITY). Give a name; one with spaces goes in double quotes");
  CHECK(scene_error("light D65 0 0 0 0") ==
        "s.sdl:1:11: light from the direction 0 0 0 (its locality is 0, so x y z is the direction "
        "it comes from). Give a direction such as 0 1 0, or the locality 1");
  CHECK(scene_error("light 0 0 0 1 1 -1") ==
        "s.sdl:1:17: -1 is out of range for light (it is a component of a linear sRGB colour). "
        "Give a number from 0 to 1000000000000000");
  CHECK(scene_error("spotlight E 0 0 0 0 1 0 0 5") ==
        "s.sdl:1:19: a spotlight has the locality 0 (a cone begins at a position). Give the "
        "locality 1");
  CHECK(scene_error("spotlight E 0 0 0 1 0 0 0 5") ==
        "s.sdl:1:21: the direction of a spotlight is 0 0 0 (spotlight takes NAME x y z LOCALITY dx "
        "dy "
        "dz angle). Give a direction such as 0 -1 0");
  for (const std::string angle : {"0", "90", "-3"})
    CHECK(scene_error("spotlight E 0 0 0 1 1 0 0 " + angle) ==
          "s.sdl:1:27: " + angle +
              " is out of range for spotlight (it is half the angle of the cone, in degrees). Give "
              "a number more than 0 and less than 90");
  CHECK(scene_error("softEdge 6 spotlight E 0 0 0 1 1 0 0 5") ==
        "s.sdl:1:38: the spotlight is narrower than its soft edge (softEdge is 6 degrees, the "
        "half-angle 5). Give a smaller softEdge before it");
  CHECK(scene_error("softEdge 91") ==
        "s.sdl:1:10: 91 is out of range for softEdge (it is the width of a spotlight's edge, in "
        "degrees). Give a number from 0 to 90");
  CHECK(scene_error("intensity -1") ==
        "s.sdl:1:11: -1 is out of range for intensity (it is a factor on the lights that follow). "
        "Give a number from 0 to 1000000000000000");
  CHECK(scene_error("falloff linear") ==
        "s.sdl:1:9: \"linear\" is no choice of falloff (falloff takes none|square). Give none or "
        "square");
}
