#include "io/libraries/read_materials.h"

#include "io/libraries/read_library.h"
#include "spectral/band_grid.h"
#include "tests/catch.h"

#include <filesystem>

using namespace abbe;

namespace {

std::vector<LibraryMaterial> materials_of(const std::string& text) {
  return read_materials_text(text, "m.mtl", [](const std::string&) {});
}

std::string error_of(const std::string& text) {
  try {
    (void)materials_of(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("the thesis's StrongOrangeYellow is read as printed") {
  int warnings = 0;
  const auto entries = read_materials(std::filesystem::path(ABBE_SOURCE_DIR) / "scenes/all.mtl",
                                      [&](const std::string&) { ++warnings; });
  CHECK(warnings == 0);
  REQUIRE(entries.size() == 1);
  const LibraryMaterial& entry = entries[0];
  CHECK(entry.name == "StrongOrangeYellow");
  double sum = 0.0;
  for (int k = 0; k < kSampleCount; ++k)
    sum += entry.colour.at(sample_nm(k));
  CHECK(sum == Approx(24.2486).epsilon(1e-12)); // appendix_a.csv, added up by awk

  const Material material = finish(entry);
  const double colour = 0.6265;
  CHECK(material.name == "StrongOrangeYellow");
  CHECK(material.reflectivity.at(600.0) == Approx(0.5 * colour));
  CHECK(material.transparency.at(600.0) == Approx(0.1 * colour));
  CHECK(material.diffuse.at(600.0) == Approx(0.3 * colour));
  CHECK(material.specular.at(600.0) == Approx(0.2 * colour));
  CHECK(material.ambient.at(600.0) == Approx(0.3 * colour));
  CHECK(material.emission.constant_value() == 0.0);
  CHECK(material.specular_exponent == 12.8);
  CHECK(material.fresnel);

  const Medium medium = filling(entry);
  CHECK(medium.name == "StrongOrangeYellow");
  CHECK(medium.index == Dispersion(ThesisScaled{1.33, 1.0}));
  CHECK(medium.absorption_per_mm.constant_value() == 0.0);
}

TEST_CASE("every amount has its own key, and what is left out is absent") {
  const auto entries = materials_of("def a { ambience 0.1 diffuseAmount 0.2 specularAmount 0.3 "
                                    "emissiveAmount 4 reflectivity 0.5 transparency 0.6 } "
                                    "endmaterial def b {}");
  REQUIRE(entries.size() == 2);
  const Material a = finish(entries[0]);
  CHECK(a.ambient.constant_value() == 0.1);
  CHECK(a.diffuse.constant_value() == 0.2);
  CHECK(a.specular.constant_value() == 0.3);
  CHECK(a.emission.constant_value() == 4.0);
  CHECK(a.reflectivity.constant_value() == 0.5);
  CHECK(a.transparency.constant_value() == 0.6);
  const Material b = finish(entries[1]);
  CHECK(b.ambient.constant_value() == 0.0);
  CHECK(b.diffuse.constant_value() == 0.0);
  CHECK(b.transparency.constant_value() == 0.0);
  CHECK(b.specular_exponent == 1.0);
  CHECK(filling(entries[1]).index == Dispersion(ThesisScaled{1.0, 0.0}));
}

TEST_CASE("our own keys: a glass of the catalogue, absorption, Fresnel") {
  const auto entries =
      materials_of("def a { transparency 1 glass n-bk7 absorption 0.02 fresnel off }");
  const Medium medium = filling(entries[0]);
  CHECK(medium.name == "N-BK7");
  CHECK(medium.index == find_glass("N-BK7")->dispersion);
  CHECK(medium.absorption_per_mm.constant_value() == 0.02);
  CHECK_FALSE(finish(entries[0]).fresnel);
}

TEST_CASE("errors of a material library") {
  CHECK(error_of("def a { reflectivity 1.5 }") ==
        "m.mtl:1:22: 1.5 is out of range for reflectivity (it is a fraction of the light). Give a "
        "number from 0 to 1");
  CHECK(error_of("def a { transparency -0.1 }") ==
        "m.mtl:1:22: -0.1 is out of range for transparency (it is a fraction of the light). Give a "
        "number from 0 to 1");
  CHECK(error_of("def a { diffuseAmount -1 }") ==
        "m.mtl:1:23: -1 is out of range for diffuseAmount (it is a factor on the colour). Give a "
        "number from 0 to 1000000000000000");
  CHECK(error_of("def a { specularExponent -1 }") ==
        "m.mtl:1:26: -1 is out of range for specularExponent (it is the exponent of the "
        "highlight). Give a number from 0 to 1000000000");
  CHECK(error_of("def a { speedOfLight 0 }") ==
        "m.mtl:1:22: 0 is out of range for speedOfLight (it is the refractive index). Give a "
        "number from 0.1 to 10");
  CHECK(error_of("def a { Vnum -1 }") ==
        "m.mtl:1:14: -1 is out of range for Vnum (it is a factor on the dispersion of quartz). "
        "Give a number 0 or more");
  CHECK(error_of("def a { absorption -1 }") ==
        "m.mtl:1:20: -1 is out of range for absorption (it is an absorption per mm). Give a number "
        "from 0 to 1000000000");
  CHECK(error_of("def a { glass N-BK8 }") ==
        "m.mtl:1:15: unknown glass \"N-BK8\" (no such name in the glass catalogue). Did you mean "
        "N-BK7?");
  CHECK(error_of("def a { glass nowhere }") ==
        "m.mtl:1:15: unknown glass \"nowhere\" (no such name in the glass catalogue). "
        "abbe list glasses shows them all");
  CHECK(error_of("def a { fresnel maybe }") ==
        "m.mtl:1:17: \"maybe\" is no choice of fresnel (fresnel takes on|off). Give on or off");
  CHECK(error_of("def a { freqBreakdown 80 0 }") ==
        "m.mtl:1:23: 80 values are announced for freqBreakdown (libraries hold values "
        "from 380 to 780 nm, in steps of 10, 5, 2 or 1 nm). Give 81 values, or 41, 201 or 401");
  CHECK(error_of("def a { alsoCalled A }") ==
        "m.mtl:1:20: \"A\" is defined twice (names must differ by more than upper and lower case). "
        "Rename or remove one of them");
  CHECK(error_of("def a { alsoCalled b } def c { alsoCalled b }") ==
        "m.mtl:1:43: \"b\" is defined twice (names must differ by more than upper and lower case). "
        "Rename or remove one of them");
  CHECK(error_of("def a { Vnumber 1 }") == "m.mtl:1:9: unknown key \"Vnumber\" (no such key in an "
                                           "entry of def). Did you mean Vnum?");
  CHECK(error_of("filter a { }") ==
        "m.mtl:1:1: \"filter\" stands where def should (an entry is def NAME { keys }). Check the "
        "braces of the entry before it");
  CHECK(error_of("def a { endmaterial") ==
        "m.mtl:1:9: \"}\" is missing before \"endmaterial\" (an entry is def NAME { keys }). Add "
        "it after the last key");
}

TEST_CASE("a second name is a second entry of the same values") {
  const auto list = read_materials_text(
      "def a { alsoCalled \"b c\" diffuseAmount 0.25 reflectivity 0.5 } def d { }", "m.mtl", {});
  REQUIRE(list.size() == 3);
  CHECK(list[0].name == "a");
  CHECK(list[1].name == "d");
  CHECK(list[2].name == "b c");
  CHECK(list[2].diffuse == 0.25);
  CHECK(list[2].reflectivity == 0.5);
}

TEST_CASE("the ColorChecker's 24 patches go by their names and by those of ISCC-NBS") {
  const std::string folder = std::string(ABBE_SOURCE_DIR) + "/scenes/";
  const auto list = read_materials(folder + "colorchecker.mtl", {});
  CHECK(list.size() == 24 + 22); // ModerateRed is both; StrongOrangeYellow is the thesis's own
  const auto same = [&](const char* name, const char* other) {
    INFO(name << ' ' << other);
    const auto *a = find_entry(list, name), *b = find_entry(list, other);
    REQUIRE(a != nullptr);
    REQUIRE(b != nullptr);
    CHECK(a->colour == b->colour);
  };
  same("DarkSkin", "ModerateBrown");
  same("Green", "StrongYellowishGreen");
  same("Red", "StrongRed");
  same("White95", "White");
  same("Black2", "Black");
  for (const LibraryMaterial& thesis : read_materials(folder + "all.mtl", {}))
    CHECK(find_entry(list, thesis.name) == nullptr); // both libraries can be used together
}

TEST_CASE("parts of a library above 1 count as 1, but for emission, and are remarked on") {
  std::string colour;
  for (int k = 0; k < kSampleCount; ++k)
    colour += k < 40 ? " 0.5" : " 4";
  const auto entries = materials_of("def bright { diffuseAmount 0.5 emissiveAmount 3 ambience 0.1\n"
                                    "freqBreakdown 81" +
                                    colour +
                                    " }\n"
                                    "def plain { diffuseAmount 1.5 }");
  REQUIRE(entries.size() == 2);
  const Material bright = finish(entries[0]), plain = finish(entries[1]);
  CHECK(bright.diffuse.at(sample_nm(0)) == 0.25);
  CHECK(bright.diffuse.at(sample_nm(80)) == 1.0);
  CHECK(bright.ambient.at(sample_nm(80)) == Approx(0.4));
  CHECK(bright.emission.at(sample_nm(80)) == 12.0);
  CHECK(plain.diffuse.constant_value() == 1.0);
  CHECK(entries[0].remarks ==
        std::vector<std::string>{"m.mtl:1:5: diffuseAmount times the colour of bright reaches 2; "
                                 "above 1 it counts as 1 (nothing reflects more than it gets)"});
  CHECK(entries[1].remarks.size() == 1);
}
