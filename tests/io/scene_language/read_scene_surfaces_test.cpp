#include "tests/io/scene_language/read_scene_helpers.h"

#include "spectral/glass.h"
#include "tests/catch.h"

using namespace abbe;

TEST_CASE("surfaces are smooth and bare unless the scene says otherwise") {
  const Material plain = scene_of("sphere").materials.at(0);
  CHECK(plain.roughness == 0.0);
  CHECK(plain.compensation);
  CHECK_FALSE(plain.film.has_value());
  CHECK_FALSE(plain.coat.has_value());
}

TEST_CASE("roughness, film and coat are parts of the current material") {
  const Scene scene = scene_of("metal Al roughness 0.3 compensation off thinFilm 100 1.38 sphere "
                               "compensation on thinFilm 0 1 sphere "
                               "glass N-BK7 thinFilm 250.5 water-20C sphere "
                               "defaultMaterials coat 1.5 sphere coat N-BK7 sphere");
  const Material& brushed = scene.materials.at(0);
  CHECK(brushed.roughness == 0.3);
  CHECK_FALSE(brushed.compensation);
  CHECK(brushed.film == ThinFilm{100.0, ConstantIndex{1.38}});
  CHECK(scene.materials.at(1).compensation);
  CHECK(scene.materials.at(1).roughness == 0.3);
  CHECK_FALSE(scene.materials.at(1).film.has_value());
  CHECK(scene.materials.at(2).roughness == 0.0); // glass begins anew
  CHECK(scene.materials.at(2).film == ThinFilm{250.5, find_glass("water-20C")->dispersion});
  CHECK(scene.materials.at(3).coat == Dispersion(ConstantIndex{1.5}));
  CHECK(scene.materials.at(4).coat == find_glass("N-BK7")->dispersion);
  CHECK(scene.materials.size() == 5);
}

TEST_CASE("a film on an operand is checked with the operand's own finish") {
  const Scene scene = scene_of("glass N-BK7 union thinFilm 100 1.38 sphere cube");
  CHECK(scene.materials.size() == 2);
  CHECK(scene_error("glass N-BK7 union coat 1.5 sphere cube") ==
        "s.sdl:1:28: coat does not go with glass or metal (it lies on the diffuse part of an "
        "opaque surface). Give defaultMaterials before it, or thinFilm instead");
}

TEST_CASE("a pane is a material of its own, of the glass that would fill a solid") {
  const Scene scene = scene_of("roughness 0.3 thinGlass 4 N-BK7 absorption 0.002 square "
                               "thinGlass 2.5 1.6 reflectivity 0.5 disc plane "
                               "glass N-BK7 sphere");
  REQUIRE(scene.materials.size() == 3);
  const Material& window = scene.materials[0];
  REQUIRE(window.pane.has_value());
  CHECK(window.pane->thickness_mm == 4.0);
  CHECK(window.pane->index == find_glass("N-BK7")->dispersion);
  CHECK(window.pane->absorption_per_mm.constant_value() == 0.002);
  CHECK(window.roughness == 0.0);
  CHECK(window.reflectivity.constant_value() == 1.0);
  CHECK(window.diffuse.constant_value() == 0.0);
  const Material& number = scene.materials[1];
  CHECK(number.pane == ThinPane{2.5, ConstantIndex{1.6}, Curve::constant(0.0)});
  CHECK(number.reflectivity.constant_value() == 0.5);
  CHECK_FALSE(scene.materials[2].pane.has_value());
  CHECK(scene.media.size() == 1); // the sphere's
}

TEST_CASE("glass on a shape without an inside is an error that names thinGlass") {
  const std::string error = "a transparent material does not go with a sheet (squares, discs, "
                            "planes and open meshes have no inside that it could fill). Give "
                            "thinGlass, a pane of some thickness, or a flat cube";
  for (const std::string shape : {"square", "disc", "plane"}) {
    CHECK(scene_error("glass N-BK7\n" + shape) == "s.sdl:2:1: " + error);
    CHECK(scene_error("speedOfLight 1.3 transparency 0.5\n" + shape) == "s.sdl:2:1: " + error);
    CHECK(scene_error("defMaterial dust glass N-BK7 defMaterial clear mix dust clear 0.5\n" +
                      shape) == "s.sdl:2:1: " + error);
    CHECK(scene_error("thinGlass 4 N-BK7 defMaterial pane defaultMaterials defMaterial dust "
                      "mix pane dust 0.5 " +
                      shape) == "no error");
    // Light goes straight through these, by shares of their own.
    CHECK(scene_error("transparency 0.5 diffuse 0 0 0 " + shape) == "no error");
    CHECK(scene_error("glass N-BK7 fresnel off transparency 0.5 reflectivity 0 " + shape) ==
          "no error");
  }
}

TEST_CASE("panes are no solids, and have bare and smooth faces") {
  const std::string solid = "thinGlass does not go with a solid (it is a pane without an inside, "
                            "for squares, discs, planes and open meshes). Give glass instead, or "
                            "one of those shapes";
  CHECK(scene_error("thinGlass 4 N-BK7\ncube") == "s.sdl:2:1: " + solid);
  CHECK(scene_error("union sphere thinGlass 4 1.5 sphere") == "s.sdl:1:30: " + solid);
  CHECK(scene_error("thinGlass 4 1.5 defMaterial pane\ndefaultMaterials defMaterial dust\n"
                    "mix pane dust 0.9 square\nsphere") == "s.sdl:4:1: " + solid);
  for (const std::string other : {"roughness 0.2", "thinFilm 100 1.3", "fresnel off"})
    CHECK(scene_error("thinGlass 4 1.5 " + other + "\nsquare") ==
          "s.sdl:2:1: " + other.substr(0, other.find_first_of(" 0")) +
              (other == "fresnel off" ? " off" : "") +
              " does not go with thinGlass (a pane has two smooth and bare faces, which reflect by "
              "Fresnel's equations). Remove it, or give a solid of glass");
  CHECK(scene_error("thinGlass 4 1.5 defMaterial pane glass N-BK7 defMaterial glass\n"
                    "mix pane glass 0.5") ==
        "s.sdl:2:1: thinGlass does not mix with glass (the one bends no light and the other does). "
        "Mix it with another thinGlass, or with a material that lets no light in");
  CHECK(scene_error("thinGlass -1 1.5") ==
        "s.sdl:1:11: -1 is out of range for thinGlass (it is a thickness in mm). Give a number "
        "from 0 to 1000000");
  CHECK(scene_error("thinGlass 4 Perspex").find("s.sdl:1:13: unknown glass \"Perspex\"") == 0);
}

TEST_CASE("errors of surfaces") {
  for (const std::string x : {"-0.1", "1.5"})
    CHECK(scene_error("roughness " + x) ==
          "s.sdl:1:11: " + x +
              " is out of range for roughness (it is a roughness). Give a number from 0 to 1");
  CHECK(scene_error("compensation yes") ==
        "s.sdl:1:14: \"yes\" is no choice of compensation (compensation takes on|off). Give on or "
        "off");
  CHECK(scene_error("thinFilm -1 1.3") ==
        "s.sdl:1:10: -1 is out of range for thinFilm (it is a thickness in nm, 0 for none). Give a "
        "number from 0 to 1000000");
  CHECK(scene_error("thinFilm 100 0") == "s.sdl:1:14: 0 is out of range for thinFilm (it is the "
                                         "refractive index). Give a number from 0.1 to 10");
  CHECK(scene_error("coat Perspex").find("s.sdl:1:6: unknown glass \"Perspex\"") == 0);
  CHECK(scene_error("coat") == "s.sdl:1:5: the end of the file stands where the name of a glass "
                               "should (coat takes n|GLASS). Give a name; one with spaces goes in "
                               "double quotes");
  CHECK(scene_error("thinFilm 100 1.3 cube") ==
        "s.sdl:1:18: thinFilm lies on neither glass nor metal (an opaque surface without an index "
        "has no light to interfere with). Give a glass, a metal or a transparency, or coat "
        "instead");
  for (const std::string below : {"metal Au", "glass N-BK7", "transparency 1"})
    CHECK(scene_error(below + "\ncoat 1.5 cube") ==
          "s.sdl:2:10: coat does not go with glass or metal (it lies on the diffuse part of an "
          "opaque surface). Give defaultMaterials before it, or thinFilm instead");
}

TEST_CASE("a glass of a film or coat is warned of like one that fills") {
  std::vector<std::string> warnings;
  (void)scene_of("coat SF11 cube coat SF11 cube glass N-BK7 thinFilm 10 SF11 cube", &warnings);
  const Glass& sf11 = *find_glass("SF11");
  CHECK(warnings.size() == (sf11.lower_nm > 377.5 || sf11.upper_nm < 782.5 ? 1 : 0));
}
