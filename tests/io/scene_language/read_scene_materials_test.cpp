#include "tests/io/scene_language/read_scene_helpers.h"

#include "spectral/glass.h"
#include "spectral/rgb_spectrum.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

const Material& finish_of(const Scene& scene, std::size_t shape) {
  return scene.materials.at(scene.shapes.at(shape).material.index());
}

const Medium& medium_of(const Scene& scene, std::size_t shape) {
  return scene.media.at(scene.shapes.at(shape).medium.index());
}

} // namespace

TEST_CASE("the default material is Hill's, opaque") {
  const Scene scene = scene_of("sphere");
  const Material& finish = finish_of(scene, 0);
  CHECK(finish.ambient.constant_value() == 0.1);
  CHECK(finish.diffuse.constant_value() == 0.8);
  CHECK(finish.specular.constant_value() == 0.0);
  CHECK(finish.specular_exponent == 1.0);
  CHECK_FALSE(scene.shapes.at(0).medium.valid());
  CHECK(scene.media.empty());
}

TEST_CASE("inline keywords change the current material, shapes keep the state they met") {
  const Scene scene =
      scene_of("ambient 0.1 0.2 0.3 diffuse 0.4 0.5 0.6 specular 0.7 0.7 0.7 emissive 2 0 0\n"
               "specularExponent 30 reflectivity 0.25 fresnel off sphere diffuse 1 1 1 sphere\n"
               "defaultMaterials sphere");
  const Material& first = finish_of(scene, 0);
  CHECK(first.ambient == rgb_reflectance({0.1, 0.2, 0.3}));
  CHECK(first.diffuse == rgb_reflectance({0.4, 0.5, 0.6}));
  CHECK(first.specular.constant_value() == 0.7);
  CHECK(first.emission == rgb_emission({2.0, 0.0, 0.0}));
  CHECK(first.specular_exponent == 30.0);
  CHECK(first.reflectivity.constant_value() == 0.25);
  CHECK_FALSE(first.fresnel);
  CHECK(finish_of(scene, 1).diffuse.constant_value() == 1.0);
  CHECK(finish_of(scene, 1).ambient == first.ambient);
  CHECK(finish_of(scene, 2).diffuse.constant_value() == 0.8);
  CHECK(finish_of(scene, 2).fresnel);
}

TEST_CASE("transparency above 0 fills the solid with speedOfLight and vnum") {
  const Scene scene =
      scene_of("speedOfLight 1.5 sphere transparency 0.9 sphere vnum 2 absorption 0.1 sphere\n"
               "fresnel off square");
  CHECK_FALSE(scene.shapes.at(0).medium.valid());
  CHECK(medium_of(scene, 1).index == Dispersion(ThesisScaled{1.5, 0.0}));
  CHECK(finish_of(scene, 1).transparency.constant_value() == 0.9);
  CHECK(medium_of(scene, 2).index == Dispersion(ThesisScaled{1.5, 2.0}));
  CHECK(medium_of(scene, 2).absorption_per_mm.constant_value() == 0.1);
  CHECK(medium_of(scene_of("vnum 2 speedOfLight 1.6 transparency 1 sphere"), 0).index ==
        Dispersion(ThesisScaled{1.6, 2.0}));
  CHECK_FALSE(scene.shapes.at(3).medium.valid()); // a square has no inside
}

TEST_CASE("UseMaterial takes finish and filling from the library; what follows changes them") {
  const Scene scene =
      scene_of("UseMaterial StrongOrangeYellow sphere transparency 0 cube vnum 3 transparency 1 "
               "prism");
  CHECK(finish_of(scene, 0).diffuse.at(600.0) == Approx(0.3 * 0.6265));
  CHECK(medium_of(scene, 0).index == Dispersion(ThesisScaled{1.33, 1.0}));
  CHECK_FALSE(scene.shapes.at(1).medium.valid());
  CHECK(medium_of(scene, 2).index == Dispersion(ThesisScaled{1.33, 3.0}));
}

TEST_CASE("glass is clear, lossless and nothing else") {
  const Scene scene = scene_of("absorption 3 glass N-BK7 sphere speedOfLight 1.2 sphere");
  const Material& finish = finish_of(scene, 0);
  CHECK(finish.name == "N-BK7");
  CHECK(finish.reflectivity.constant_value() == 1.0);
  CHECK(finish.transparency.constant_value() == 1.0);
  CHECK(finish.ambient.constant_value() == 0.0);
  CHECK(finish.diffuse.constant_value() == 0.0);
  CHECK(finish.fresnel);
  CHECK(medium_of(scene, 0).name == "N-BK7");
  CHECK(medium_of(scene, 0).index == find_glass("N-BK7")->dispersion);
  CHECK(medium_of(scene, 0).absorption_per_mm.constant_value() == 0.0);
  CHECK(medium_of(scene, 1).index == Dispersion(ThesisScaled{1.2, 0.0}));
}

TEST_CASE("equal states share one material and one medium") {
  const Scene scene = scene_of("glass N-BK7 sphere cube glass N-BK7 sphere\n"
                               "defaultMaterials sphere glass n-bk7 sphere");
  CHECK(scene.materials.size() == 2);
  CHECK(scene.media.size() == 1);
  CHECK(scene.shapes.at(0).material == scene.shapes.at(4).material);
  CHECK(scene.shapes.at(0).medium == scene.shapes.at(4).medium);
  CHECK_FALSE(scene.shapes.at(0).material == scene.shapes.at(3).material);
}

TEST_CASE("a state that no shape meets leaves nothing behind") {
  const Scene scene = scene_of("glass N-BK7 diffuse 1 0 0 defaultMaterials sphere");
  CHECK(scene.materials.size() == 1);
  CHECK(scene.media.empty());
}

TEST_CASE("priority holds for the shapes that follow") {
  const Scene scene = scene_of("sphere priority -2 sphere lens sphere sphere");
  CHECK(scene.shapes.at(0).priority == 0);
  CHECK(scene.shapes.at(1).priority == -2);
  CHECK(scene.shapes.at(2).priority == -2);
}

TEST_CASE("a glass that is fitted for less than the pictures' range warns once") {
  std::vector<std::string> warnings;
  (void)scene_of("glass K5 sphere glass K5 cube glass N-BK7 sphere", &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:1: glass K5 is extrapolated beyond 400-700 nm (pictures need "
                         "377.5-782.5 nm)") != std::string::npos);
}

TEST_CASE("a reflectance above 1 counts as 1, with a warning") {
  std::vector<std::string> warnings;
  const Scene scene = scene_of("diffuse 1.5 2 1 sphere", &warnings);
  CHECK(finish_of(scene, 0).diffuse.constant_value() == 1.0);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:1: diffuse above 1 counts as 1 (nothing reflects more than it "
                         "gets)") != std::string::npos);
}

TEST_CASE("errors of materials") {
  CHECK(scene_error("UseMaterial Red") ==
        "s.sdl:1:13: unknown material \"Red\" (there is no all.mtl beside the scene, and no "
        "materials keyword). Add it to the material library, or name another one");
  const std::string folder = (std::filesystem::path(ABBE_SOURCE_DIR) / "scenes").string();
  REQUIRE_THROWS_WITH(scene_of("UseMaterial OrangeYellow"),
                      folder +
                          "/test.sdl:1:13: unknown material \"OrangeYellow\" (no such name in " +
                          folder + "/all.mtl). Did you mean StrongOrangeYellow?");
  CHECK(scene_error("UseMaterial") ==
        "s.sdl:1:12: the end of the file stands where the name of a material should (UseMaterial "
        "takes NAME). Give a name; one with spaces goes in double quotes");
  CHECK(scene_error("glass BK7") == "s.sdl:1:7: unknown glass \"BK7\" (no such name in the glass "
                                    "catalogue). Did you mean K7 or N-BK7?");
  CHECK(scene_error("glass N-BK7 vnum 2") ==
        "s.sdl:1:13: vnum does not go with glass (what fills the solid has its own "
        "dispersion). Remove it, or give speedOfLight before it");
  CHECK(scene_error("reflectivity 1.1") ==
        "s.sdl:1:14: 1.1 is out of range for reflectivity (it is a fraction of the light). Give a "
        "number from 0 to 1");
  CHECK(scene_error("transparency -1") ==
        "s.sdl:1:14: -1 is out of range for transparency (it is a fraction of the light). Give a "
        "number from 0 to 1");
  CHECK(scene_error("speedOfLight 0") ==
        "s.sdl:1:14: 0 is out of range for speedOfLight (it is the refractive index). Give a "
        "number from 0.1 to 10");
  CHECK(scene_error("vnum -1") == "s.sdl:1:6: -1 is out of range for vnum (it is a factor on the "
                                  "dispersion of quartz). Give a number 0 or more");
  CHECK(scene_error("absorption -1") == "s.sdl:1:12: -1 is out of range for absorption (it is an "
                                        "absorption per mm). Give a number from 0 to 1000000000");
  CHECK(scene_error("specularExponent -1") ==
        "s.sdl:1:18: -1 is out of range for specularExponent (it is the exponent of the "
        "highlight). Give a number from 0 to 1000000000");
  CHECK(scene_error("ambient 0 0 -1") ==
        "s.sdl:1:13: -1 is out of range for ambient (it is a component of a linear sRGB colour). "
        "Give a number from 0 to 1000000000000000");
  const std::string impossible = scene_error("transparency 1 speedOfLight 0.5 vnum 100 sphere");
  CHECK(impossible.starts_with("s.sdl:1:42: the solid's refractive index is "));
  CHECK(impossible.ends_with("which no clear medium has (it must lie between 0.1 and 10 at every "
                             "wavelength). Check speedOfLight and vnum"));
  CHECK(scene_error("priority 3000000000") ==
        "s.sdl:1:10: 3000000000 is out of range for priority (it is a rank). Give a number from "
        "-2147483647 to 2147483647");
}
