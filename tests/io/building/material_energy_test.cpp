#include "io/building/material_energy.h"

#include "io/scene_language/read_scene.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace abbe;

namespace {

Scene read(const std::string& text, std::vector<std::string>& warnings) {
  return read_scene_text(text, "s.sdl",
                         [&](const std::string& message) { warnings.push_back(message); });
}

std::vector<std::string> warnings_of(const std::string& text) {
  std::vector<std::string> warnings;
  (void)read(text, warnings);
  return warnings;
}

} // namespace

TEST_CASE("a transparent body has no ambient and diffuse part that nobody has given it") {
  std::vector<std::string> warnings;
  const Scene scene = read("sphere speedOfLight 1.5 transparency 1 reflectivity 1 sphere\n"
                           "diffuse 0.1 0.1 0.1 cube ambient 0.2 0.2 0.2 cube\n"
                           "defaultMaterials transparency 1 defMaterial clear\n"
                           "defaultMaterials useMaterial clear sphere transparency 0 sphere\n"
                           "defaultMaterials speedOfLight 1.2 transparency 1 union sphere cube",
                           warnings);
  const auto part = [&](std::size_t shape, Curve Material::* which) {
    return (scene.materials[scene.shapes[shape].material.index()].*which).constant_value();
  };
  CHECK(part(0, &Material::diffuse) == 0.8);
  CHECK(part(1, &Material::diffuse) == 0.0);
  CHECK(part(1, &Material::ambient) == 0.0);
  CHECK(part(2, &Material::diffuse) == Approx(0.1));
  CHECK(part(2, &Material::ambient) == 0.0);
  CHECK(part(3, &Material::ambient) == Approx(0.2));
  CHECK(part(4, &Material::diffuse) == 0.0);
  CHECK(part(5, &Material::diffuse) == 0.8); // opaque again
  CHECK(part(6, &Material::diffuse) == 0.0);
  // The operands have the whole's material, and no other.
  for (const CsgLeaf& leaf : std::get<CsgTree>(scene.shapes[6].shape).leaves())
    CHECK_FALSE(leaf.material.valid());
}

TEST_CASE("the share that a material gives back is the sum of its parts") {
  Material m;
  m.diffuse = Curve::constant(0.5);
  m.reflectivity = Curve::constant(0.3);
  CHECK(most_given_back(m, {}).most == Approx(0.8));
  m.transparency = Curve::constant(0.4);
  CHECK(most_given_back(m, {}).most == Approx(0.9)); // of what Fresnel's equations share out
  m.fresnel = false;
  CHECK(most_given_back(m, {}).most == Approx(1.2));
  m.texture = CheckerTexture{1, 1, Curve::constant(0.2), Curve::constant(0.9)};
  CHECK(most_given_back(m, {}).most == Approx(1.6));
  m.texture = ImageTexture{0};
  const std::vector<ReflectanceImage> images{{1, 2, {0.1f, 0.2f, 0.1f, 0.3f, 0.25f, 0.0f}}};
  CHECK(most_given_back(m, images).most == Approx(1.0));
  m = {};
  m.diffuse = Curve::constant(0.6);
  m.reflectivity = Curve::table({500, 600}, {0.1, 0.7});
  const MaterialEnergy red = most_given_back(m, {});
  CHECK(red.most == Approx(1.3));
  CHECK(red.at_nm >= 600.0);
  m.coat = ConstantIndex{1.5}; // which takes the place of reflectivity
  CHECK(most_given_back(m, {}).most == Approx(0.6));
}

TEST_CASE("a highlight gives back what its integral says") {
  // By the midpoint rule: 1/pi cos^e(theta / 2) over the hemisphere, for light from above.
  for (const double e : {0.0, 1.0, 2.0, 10.0, 100.0}) {
    double sum = 0.0;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      const double theta = (i + 0.5) * std::numbers::pi / 2 / kSteps;
      sum +=
          2.0 * std::sin(theta) * std::pow(std::cos(theta / 2), e) * std::numbers::pi / 2 / kSteps;
    }
    Material m;
    m.specular = Curve::constant(0.5);
    m.specular_exponent = e;
    CHECK(most_given_back(m, {}).highlight == Approx(0.5 * sum).epsilon(1e-6));
  }
}

TEST_CASE("a material that gives back more than it gets is warned of at its shape, once") {
  CHECK(warnings_of("reflectivity 0.6 sphere sphere") ==
        std::vector<std::string>{
            "s.sdl:1:18: the material gives back up to 1.4 times the light that it gets, at 377.5 "
            "nm (diffuse 0.8, highlight 0, mirrored or let through 0.6)"});
  CHECK(
      warnings_of("reflectivity 0.2 sphere coat 1.5 defaultMaterials diffuse 1 1 1 cube").empty());
  CHECK(warnings_of("transparency 1 reflectivity 1 diffuse 0.5 0.5 0.5 sphere").size() == 1);
  CHECK(
      warnings_of("glass N-BK7 sphere metal Al cube thinGlass 2 1.5 square drops 1 cube").empty());
  CHECK(warnings_of("checker 2 2 0.9 0.9 0.9 0 0 0 reflectivity 0.3 square").size() == 1);
  CHECK(warnings_of("reflectivity 0.6 defMaterial a diffuse 0 0 0 defMaterial b\n"
                    "mix a b 0.5 square")
            .size() == 1);
}

TEST_CASE("shares that add up to more than 1 are lowered in proportion") {
  std::vector<std::string> warnings;
  const Scene scene =
      read("fresnel off reflectivity 1 transparency 0.6 diffuse 0 0 0\nsphere", warnings);
  CHECK(scene.materials[0].reflectivity.constant_value() == Approx(1.0 / 1.6));
  CHECK(scene.materials[0].transparency.constant_value() == Approx(0.6 / 1.6));
  CHECK(warnings == std::vector<std::string>{
                        "s.sdl:2:1: reflectivity and transparency of the material add up to 1.6 "
                        "with fresnel off; they are lowered so that they add up to 1"});
  CHECK(warnings_of("fresnel off reflectivity 0.3 transparency 0.7 diffuse 0 0 0 sphere").empty());
}
