#include "io/libraries/read_materials.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

#include <cmath>

using namespace abbe;

TEST_CASE("a metal is a mirror and fills nothing") {
  const Scene scene = scene_of("glass N-BK7 metal au reflectivity 0.9 sphere glass N-BK7 sphere");
  const Material& gold = scene.materials.at(0);
  REQUIRE(gold.metal.has_value());
  CHECK(gold.metal->n == find_metal("Au")->n);
  CHECK(gold.metal->k == find_metal("Au")->k);
  CHECK(gold.reflectivity.constant_value() == 0.9);
  CHECK(gold.diffuse.constant_value() == 0.0);
  CHECK_FALSE(scene.shapes.at(0).medium.valid());
  CHECK_FALSE(scene.materials.at(1).metal.has_value());
  CHECK(scene.materials.size() == 2);
}

TEST_CASE("a library's entry is of metal, in its colour") {
  const auto entry =
      read_materials_text("def a { metal Cu reflectivity 0.8 transparency 1 }", "m.mtl", {}).at(0);
  const Material copper = finish(entry);
  REQUIRE(copper.metal.has_value());
  CHECK(copper.metal->k == find_metal("Cu")->k);
  CHECK(copper.reflectivity.at(500.0) == 0.8);
  CHECK(copper.transparency.constant_value() == 0.0);
}

// T = exp(-a d), so a = -ln(T)/d.
TEST_CASE("internalTransmittance is the colour behind that much glass") {
  const auto absorption = [](const Scene& scene) { return scene.media.at(0).absorption_per_mm; };
  const Curve blue = absorption(scene_of("glass N-BK7 internalTransmittance 0.1 0.4 0.9 25 cube"));
  const Curve color = rgb_reflectance({0.1, 0.4, 0.9});
  for (const double nm : {400.0, 500.0, 650.0, 780.0})
    CHECK(std::exp(-25.0 * blue.at(nm)) == Approx(color.at(nm)).epsilon(1e-12));
  CHECK(absorption(scene_of("glass N-BK7 internalTransmittance 0.5 0.5 0.5 2 cube"))
            .constant_value() == Approx(std::log(2.0) / 2.0).epsilon(1e-9));
  CHECK(absorption(scene_of("glass N-BK7 internalTransmittance 0 0 0 1 cube")).constant_value() ==
        Approx(std::log(1e6)).epsilon(1e-12));
  const Curve table = absorption(scene_of("glass N-BK7 absorptionTable 2 400 0.3 700 0 cube"));
  CHECK(table.at(550.0) == Approx(0.15));
  CHECK(table.at(780.0) == 0.0);
}

TEST_CASE("a library's entry is of coloured glass") {
  const auto absorption = [](const std::string& keys) {
    return filling(read_materials_text("def a { " + keys + " }", "m.mtl", {}).at(0))
        .absorption_per_mm;
  };
  CHECK(absorption("absorption 0.2").constant_value() == 0.2);
  CHECK(absorption("absorptionTable 2 400 0.3 700 0.1").at(550.0) == Approx(0.2));
  CHECK(absorption("internalTransmittance 0.5 0.5 0.5 2").constant_value() ==
        Approx(std::log(2.0) / 2.0).epsilon(1e-9));
}

TEST_CASE("errors of metals and coloured glass") {
  CHECK(scene_error("metal Unobtainium") == "s.sdl:1:7: unknown metal \"Unobtainium\" (no such "
                                            "symbol in the catalogue of metals). The metals "
                                            "are Ag Al Au Cr Cu Fe Ni Pt Ti W");
  CHECK(scene_error("metal") ==
        "s.sdl:1:6: the end of the file stands where the name of a metal should (metal takes "
        "NAME|FILE). Give a name; one with spaces goes in double quotes");
  CHECK(scene_error("metal Au transparency 0.5") ==
        "s.sdl:1:10: transparency does not go with metal (what a metal does not reflect it takes "
        "in). Give a glass, or remove it");
  CHECK(scene_error("absorptionTable 1 500 -1") ==
        "s.sdl:1:23: -1 is out of range for absorptionTable (it is an absorption per mm). Give a "
        "number from 0 to 1000000000");
  CHECK(scene_error("internalTransmittance 2 0 0 1") ==
        "s.sdl:1:23: 2 is out of range for internalTransmittance (it is a share of light that "
        "passes, linear sRGB). Give a number from 0 to 1");
  CHECK(scene_error("internalTransmittance 1 1 1 0") ==
        "s.sdl:1:29: 0 is out of range for internalTransmittance (it is a thickness in mm). Give a "
        "number more than 0");
}

TEST_CASE("a library warns of an entry when it is used, not when it is looked through") {
  std::vector<std::string> warnings;
  (void)scene_of("background D65 light D65 0 9 0 1 sphere", &warnings);
  CHECK(warnings.empty());
  (void)scene_of("light 2a 0 9 0 1 light 2a 0 9 0 1 sphere", &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("lights.filter:31:12: 3 zeros after the 81 values") != std::string::npos);
}
