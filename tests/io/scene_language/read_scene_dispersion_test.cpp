#include "io/libraries/read_materials.h"
#include "spectral/glass.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

using namespace abbe;

namespace {

const Medium& medium_of(const Scene& scene) {
  return scene.media.at(scene.shapes.at(0).medium.index());
}

std::string library_error(const std::string& keys) {
  try {
    (void)read_materials_text("def a { " + keys + " }", "m.mtl", {});
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("an index that is written out is a clear glass") {
  const Scene scene = scene_of("diffuse 1 0 0 cauchy 1.5 0.004 0.0001 sphere");
  CHECK(medium_of(scene).index == Dispersion(Cauchy{1.5, 0.004, 0.0001}));
  CHECK(scene.materials.at(0).transparency.constant_value() == 1.0);
  CHECK(scene.materials.at(0).reflectivity.constant_value() == 1.0);
  CHECK(scene.materials.at(0).diffuse.constant_value() == 0.0);
  CHECK(medium_of(scene_of("abbe 1.5168 64.17 sphere")).index ==
        Dispersion(cauchy_of_abbe(1.5168, 64.17)));
  CHECK(medium_of(scene_of("quartz linear sphere")).index == Dispersion(ThesisLinear{}));
  CHECK(medium_of(scene_of("quartz polynomial sphere")).index == Dispersion(ThesisPolynomial{}));
}

TEST_CASE("points of n are joined or fitted, and the reader tells what is odd") {
  std::vector<std::string> warnings;
  const Scene joined = scene_of("indexTable 2 400 1.6 700 1.5 sphere", &warnings);
  CHECK(medium_of(joined).index == Dispersion(tabulated_index({400.0, 700.0}, {1.6, 1.5})));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:1: indexTable has no dispersion beyond 400-700 nm (pictures "
                         "need 377.5-782.5 nm; indexFit would go on)") != std::string::npos);
  warnings.clear();
  const Scene fitted = scene_of("indexFit 3 486 1.52 588 1.516 656 1.514 sphere", &warnings);
  CHECK(refractive_index(medium_of(fitted).index, 588.0) == Approx(1.516).epsilon(1e-12));
  CHECK(warnings.empty());
  CHECK(medium_of(fitted).name.starts_with("indexFit, which misses its points by up to "));
  (void)scene_of("indexFit 5 400 1.5 450 1.6 500 1.5 600 1.6 700 1.5 sphere", &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("test.sdl:1:1: indexFit misses its points by up to ") !=
        std::string::npos);
}

TEST_CASE("dispersionScale exaggerates what is current, until the next index") {
  const Dispersion bk7 = find_glass("N-BK7")->dispersion;
  CHECK(medium_of(scene_of("glass N-BK7 dispersionScale 4 sphere")).index == exaggerated(bk7, 4));
  CHECK(medium_of(scene_of("glass N-BK7 dispersionScale 4 dispersionScale 2 sphere")).index ==
        exaggerated(bk7, 2));
  CHECK(medium_of(scene_of("dispersionScale 4 glass N-BK7 sphere")).index == bk7);
}

TEST_CASE("a library's entry has an index by a law too") {
  const auto entry = [](const std::string& keys) {
    return filling(read_materials_text("def a { transparency 1 " + keys + " }", "m.mtl", {}).at(0));
  };
  CHECK(entry("cauchy 1.5 0.004 0").index == Dispersion(Cauchy{1.5, 0.004, 0.0}));
  CHECK(entry("dispersionScale 3 abbe 1.6 36").index == exaggerated(cauchy_of_abbe(1.6, 36), 3));
  CHECK(entry("indexTable 1 500 1.5").index == Dispersion(tabulated_index({500.0}, {1.5})));
  CHECK(entry("quartz linear").index == Dispersion(ThesisLinear{}));
  CHECK(refractive_index(entry("indexFit 1 500 1.5").index, 600.0) == Approx(1.5).epsilon(1e-14));
}

TEST_CASE("errors of an index that is written out") {
  CHECK(scene_error("cauchy 0 0.1 0") == "s.sdl:1:8: 0 is out of range for cauchy (it is the "
                                         "refractive index). Give a number from 0.1 to 10");
  CHECK(scene_error("cauchy 1.5 2000 0") ==
        "s.sdl:1:12: 2000 is out of range for cauchy (it is a coefficient in um^2). Give a number "
        "from -1000 to 1000");
  CHECK(scene_error("cauchy 1.5 0.1 2000") ==
        "s.sdl:1:16: 2000 is out of range for cauchy (it is a coefficient in um^4). Give a number "
        "from -1000 to 1000");
  CHECK(scene_error("cauchy 1.5 0.1 sphere") ==
        "s.sdl:1:16: \"sphere\" is not a number (cauchy takes A B C). Give a finite number such as "
        "2, -0.5 or 1e-3");
  CHECK(scene_error("abbe 1.5 0") == "s.sdl:1:10: 0 is out of range for abbe (it is the Abbe "
                                     "number). Give a number from 1 to 1000000");
  CHECK(scene_error("indexTable 0") == "s.sdl:1:12: 0 is out of range for indexTable (it is the "
                                       "number of points). Give a number from 1 to 10000");
  CHECK(scene_error("indexTable 2 500 1.5 400 1.6") ==
        "s.sdl:1:22: the wavelengths of indexTable do not ascend (400 follows 500). Sort the "
        "points, each wavelength once");
  CHECK(scene_error("indexFit 1 0 1.6") == "s.sdl:1:12: 0 is out of range for indexFit (it is a "
                                           "wavelength in nm). Give a number more than 0");
  CHECK(scene_error("indexFit 1 500 0") == "s.sdl:1:16: 0 is out of range for indexFit (it is the "
                                           "refractive index). Give a number from 0.1 to 10");
  CHECK(scene_error("quartz cubic") ==
        "s.sdl:1:8: \"cubic\" is no choice of quartz (quartz takes linear|polynomial). Give linear "
        "or polynomial");
  CHECK(scene_error("dispersionScale -1") ==
        "s.sdl:1:17: -1 is out of range for dispersionScale (it is a factor on the dispersion). "
        "Give a number 0 or more");
  const std::string strong = scene_error("glass N-SF11 dispersionScale 100 sphere");
  CHECK(strong.starts_with("s.sdl:1:34: the solid's refractive index is "));
  CHECK(strong.ends_with("which no clear medium has (it must lie between 0.1 and 10 at every "
                         "wavelength). Check the numbers of its index, or lower "
                         "dispersionScale"));
  CHECK(library_error("glass N-BK7 abbe 1.5 60") ==
        "m.mtl:1:21: abbe is a second index of this entry (one law gives n at every wavelength). "
        "Remove one of them");
  CHECK(library_error("abbe 1.5 60 glass N-BK7") ==
        "m.mtl:1:21: glass is a second index of this entry (one law gives n at every wavelength). "
        "Remove one of them");
  CHECK(library_error("dispersionScale -1") ==
        "m.mtl:1:25: -1 is out of range for dispersionScale (it is a factor on the dispersion). "
        "Give a number 0 or more");
}
