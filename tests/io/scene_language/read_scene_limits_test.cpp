#include "io/libraries/read_lens_prescription.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"
#include "tests/io/scene_language/read_scene_helpers.h"

#include <string>

using namespace abbe;

namespace {

double abbe_number_of(const Dispersion& index) {
  return (refractive_index(index, kLineD_nm) - 1.0) /
         (refractive_index(index, kLineF_nm) - refractive_index(index, kLineC_nm));
}

LensPrescription lens_of(const std::string& text) {
  return read_lens_prescription_text(text, "l.lens", {});
}

std::string lens_error(const std::string& text) {
  try {
    (void)lens_of(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("a glass stands by its six digits wherever one may stand") {
  for (const std::string text : {"glass 603606 sphere", "glass 603606.251 sphere"}) {
    const Scene scene = scene_of(text);
    CHECK(refractive_index(scene.media[0].index, kLineD_nm) == Approx(1.603).epsilon(1e-12));
    CHECK(abbe_number_of(scene.media[0].index) == Approx(60.6).epsilon(1e-9));
  }
  const LensPrescription lens = lens_of("stop surface 50 5 603606 10 surface -50 40 air 10");
  CHECK(refractive_index(lens.surfaces[0].medium_after, kLineD_nm) == Approx(1.603).epsilon(1e-12));
  CHECK(abbe_number_of(lens.surfaces[0].medium_after) == Approx(60.6).epsilon(1e-9));
  const Scene dense = scene_of("glass 003283 sphere"); // S-LAH79: n_d 2.0033, V_d 28.27
  CHECK(refractive_index(dense.media[0].index, kLineD_nm) == Approx(2.003).epsilon(1e-12));
  const Scene coated = scene_of("coat 517642 sphere");
  CHECK(refractive_index(*coated.materials[0].coat, kLineD_nm) == Approx(1.517).epsilon(1e-12));
  CHECK(scene_error("glass 603005") ==
        "s.sdl:1:7: 603005 is the code of no glass (its last three digits give an Abbe number of "
        "0.5). Give a code such as 517642, for n_d 1.517 and V_d 64.2");
}

TEST_CASE("no medium has an index or an Abbe number out of this world") {
  for (const std::string n : {"1e-300", "0.05", "11", "1e300"})
    for (const std::string keyword : {"speedOfLight ", "coat ", "thinFilm 400 ", "thinGlass 4 "})
      CHECK(scene_error(keyword + n).find(n + " is out of range for") != std::string::npos);
  CHECK(scene_error("drops 1 dropIndex 1e300").find("1e300 is out of range") != std::string::npos);
  CHECK(scene_error("abbe 0.9 60") ==
        "s.sdl:1:6: 0.9 with an Abbe number is no medium (below an index of 1 an Abbe number above "
        "0 would mean that n rises with the wavelength). Give an n_d of 1 or more, or "
        "speedOfLight, cauchy or indexTable");
  CHECK(scene_error("cauchy 1.5 1000 0 sphere").find("which no clear medium has") !=
        std::string::npos);
}

TEST_CASE("light has a limit that sums can hold") {
  for (const std::string text : {"background D65 ", "emissive 0 0 ", "intensity "})
    for (const std::string value : {"1e16", "3e38", "1e300"})
      CHECK(scene_error(text + value).find(value + " is out of range for") != std::string::npos);
  CHECK(scene_error("background D65 1e15 intensity 1e15") == "no error");
}

TEST_CASE("surfaces of a camera lens that cross are refused") {
  // Each sag at 10 mm is 15 - sqrt(125) = 3.8197 mm; 1 mm lies between the vertices.
  CHECK(lens_error("stop surface 15 1 N-BK7 10\nsurface -15 5 air 10") ==
        "l.lens:2:1: this surface crosses the one before it (at 10 mm from the axis it lies 6.64 "
        "mm before it). Check the signs of the radii, the thickness and the semi-diameters");
  CHECK(lens_error("stop surface 15 8 N-BK7 10 surface -15 5 air 10") == "no error");
  CHECK(
      lens_error("stop surface 15 8 N-BK7 16 surface -15 5 air 10") ==
      "l.lens:1:6: the semi-diameter is larger than the radius (a ball has no surface so far from "
      "the axis). Check both numbers");
}

TEST_CASE("macros that double end in an error that names one") {
  std::string text = "def a0 { sphere }\n";
  for (int i = 1; i <= 40; ++i)
    text += "def a" + std::to_string(i) + " { use a" + std::to_string(i - 1) + " use a" +
            std::to_string(i - 1) + " }\n";
  const std::string error = scene_error(text + "use a40");
  CHECK(error.find("the scene grows too large at macro a") != std::string::npos);
  CHECK(error.find("macros and included files bring more than 10000000 words in all") !=
        std::string::npos);
}

TEST_CASE("an endless word is refused, and an unknown long one fast") {
  CHECK(scene_error(" " + std::string(4097, 'x')) ==
        "s.sdl:1:2: a word is longer than 4096 bytes (it begins with \"xxxxxxxxxxxxxxxx\"). Break "
        "it up, or check that this is the file you meant");
  CHECK(scene_error(std::string(4096, 'x')).find("unknown keyword") != std::string::npos);
  CHECK(scene_error(std::string(10'000'000, 'x')).size() < 200);
}

TEST_CASE("what cannot be read is told at the statement that names it") {
  CHECK(scene_error("include /dev/null") ==
        "s.sdl:1:9: \"/dev/null\" cannot be read (it is a device). Name a file that can be read");
  CHECK(scene_error("lights /").find("s.sdl:1:8: \"/\" cannot be read (it is a folder)") == 0);
}

TEST_CASE("what is too far off is told at its place") {
  CHECK(scene_error("sphere eye 1e160 0 1e160") ==
        "s.sdl:1:8: the eye is too far off (it reaches 1e+160 units from the origin, and rays can "
        "be followed to 1e+17). Bring it nearer, or measure in larger units");
  const auto begins = [](const std::string& text, const std::string& message) {
    const std::string error = scene_error(text);
    CAPTURE(text, error);
    CHECK(error.find(message) == 0);
  };
  begins("eye 0 0 9\n light 0 1e40 1e40 1 1 1", "s.sdl:2:2: the light is too far off (it reaches");
  begins("light E 0 2e17 0 1", "s.sdl:1:1: the light is too far off");
  begins("translate 0 -1e20 0 spotlight E 0 0 0 1 0 1 0 5", "s.sdl:1:21: the light is too far");
  for (const std::string shape : {"sphere", "cube", "square", "prism", "plane",
                                  "polyhedron vertices 4 0 0 0 1 0 0 0 1 0 0 0 1"})
    begins("push translate 1e30 0 0 rotate 90 0 1 0 " + shape + " pop",
           "s.sdl:1:41: the shape is too far off");
  begins("scale 1e19 1e19 1e19 union sphere cube", "s.sdl:1:22: the shape is too far off");
  CHECK_NOTHROW(scene_of("eye 0 0 9e16 light E 0 9e16 0 1 light E 0 1e30 0 0\n"
                         "push translate 1e30 0 0 plane pop translate 9e16 0 0 sphere"));
}
