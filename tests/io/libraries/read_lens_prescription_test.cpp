#include "io/libraries/read_lens_prescription.h"

#include "spectral/fraunhofer.h"
#include "tests/catch.h"

#include <string>
#include <vector>

using namespace abbe;

namespace {

LensPrescription lens_of(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  return read_lens_prescription_text(text, "l.lens", [&](const std::string& message) {
    if (warnings) warnings->push_back(message);
  });
}

std::string error_of(const std::string& text) {
  try {
    (void)lens_of(text);
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

void check_error(const std::string& text, const std::string& message) {
  CHECK_THAT(error_of(text), Catch::Matchers::ContainsSubstring(message));
}

const std::string kSinglet = "stop surface 50 3 N-BK7 8 surface -50 48 air 8";

} // namespace

TEST_CASE("a lens file's surfaces") {
  const LensPrescription lens = lens_of("! a lens\nUNIT in  fNumber 4  halfField 10\n"
                                        "surface 2 0.5 N-BK7 1\n"
                                        "STOP surface inf 0.25 1.6 40\n"
                                        "surface -2 1 air 0.5");
  CHECK(lens.name == "l");
  REQUIRE(lens.surfaces.size() == 3);
  CHECK(lens.stop == 1);
  CHECK(lens.f_number == 4.0);
  CHECK(lens.half_field_deg == 10.0);
  CHECK(lens.surfaces[0].radius_mm == 2 * 25.4);
  CHECK(lens.surfaces[0].thickness_mm == 0.5 * 25.4);
  CHECK(lens.surfaces[0].semi_diameter_mm == 25.4);
  CHECK(refractive_index(lens.surfaces[0].medium_after, kLineD_nm) == Approx(1.5168).epsilon(1e-6));
  CHECK(lens.surfaces[1].radius_mm == 0.0);
  CHECK_FALSE(lens.surfaces[1].semi_diameter_mm);
  CHECK(refractive_index(lens.surfaces[1].medium_after, kLineD_nm) == Approx(1.6));
  CHECK(abbe_number(lens.surfaces[1].medium_after) == Approx(40.0));
  CHECK(lens.surfaces[2].medium_after == Dispersion(ConstantIndex{1.0}));
}

TEST_CASE("a lens file warns once of a glass that is extrapolated") {
  std::vector<std::string> warnings;
  (void)lens_of("stop surface 50 3 fused-silica 8 surface -50 48 air 8", &warnings);
  CHECK(warnings.empty());
  (void)lens_of("stop surface 50 3 N-SF66 8\n surface inf 3 N-SF66 8 surface -50 48 air 8",
                &warnings);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Matchers::ContainsSubstring(
                              "l.lens:1:19: glass N-SF66 is extrapolated beyond"));
}

TEST_CASE("mistakes in a lens file") {
  CHECK(error_of(kSinglet) == "no error");
  check_error(kSinglet + "\nsurfaces 1",
              "l.lens:2:1: unknown keyword \"surfaces\" (no such word in a lens file). Did you "
              "mean surface?");
  check_error("12",
              "l.lens:1:1: unknown keyword \"12\" (no such word in a lens file). The keywords "
              "are unit, fNumber, halfField, stop and surface");
  check_error(kSinglet + " unit in", "unit stands too late (surfaces before it have been read). "
                                     "Move it before the first surface");
  check_error("unit ft", "l.lens:1:6: ");
  check_error("fNumber 0",
              "l.lens:1:9: 0 is out of range for fNumber (it is focal length by aperture");
  check_error("halfField 90",
              "l.lens:1:11: 90 is out of range for halfField (it is half of the angle of view");
  check_error("surface 50 -3",
              "l.lens:1:12: -3 is out of range for surface (it is the way to the next surface");
  check_error("surface 50 3 N-BK8", "l.lens:1:14: unknown glass \"N-BK8\"");
  check_error("surface 50 3 0 60",
              "l.lens:1:14: 0 is out of range for surface (it is the refractive index");
  check_error("surface 50 3 1.5 0",
              "l.lens:1:18: 0 is out of range for surface (it is the Abbe number");
  check_error("surface 50 3 air 0",
              "l.lens:1:18: 0 is out of range for surface (it is half of a diameter");
  check_error("surface 50", "l.lens:1:11: the file ends where a number should stand");
  check_error("", "l.lens: the lens has no surface (a lens needs glass)");
  check_error("surface 50 3 N-BK7 8 surface -50 48 air 8",
              "l.lens: the lens has no stop (none of its surfaces limits the aperture). Write stop "
              "before");
  check_error(kSinglet + "\nstop", "l.lens:2:1: stop is given twice (the first is at l.lens:1:1)");
  check_error("surface 50 3 N-BK7 8 surface -50 48 air 8 stop",
              "l.lens:1:43: no surface follows stop (it marks the surface behind it)");
}

TEST_CASE("lens files that describe no camera lens") {
  const auto check_why = [](const std::string& text, const std::string& why) {
    check_error(text, "l.lens: these data describe no camera lens (" + why);
  };
  check_why("stop surface -50 3 N-BK7 8 surface 50 48 air 8",
            "it does not gather light: its focal length is not positive");
  check_why("stop surface 50 3 N-BK7 8", "there is no air behind its last surface");
  check_why("stop surface 50 3 N-BK7 surface -50 48 air 8",
            "its stop has no semi-diameter, and there is no f-number");
  check_why("fNumber 0.1 stop surface 50 3 N-BK7 surface -50 48 air",
            "it cannot be opened to its f-number");
}

TEST_CASE("aspheric surfaces have a conic constant and even powers, in the unit of the file") {
  const LensPrescription lens = lens_of(
      "unit cm stop surface 2 1 1.5 60 0.8 conic -0.7 even 4 1e-3 8 -2 surface inf 3 air 0.8");
  CHECK(lens.surfaces[0].conic == -0.7);
  REQUIRE(lens.surfaces[0].even_terms.size() == 4); // of h^2 to h^8
  CHECK(lens.surfaces[0].even_terms[0] == 0.0);
  CHECK(lens.surfaces[0].even_terms[1] == Approx(1e-6)); // cm^-3 are 1e-3 mm^-3
  CHECK(lens.surfaces[0].even_terms[3] == Approx(-2e-7));
  CHECK(lens.surfaces[1].conic == 0.0);
  check_error("stop surface 20 5 1.5 60 8 even 3 1 surface inf 20 air 8",
              "l.lens:1:33: 3 is an odd power");
  check_error("stop surface 20 5 1.5 60 conic -1 surface inf 20 air 8",
              "l.lens:1:6: an aspheric surface has no semi-diameter");
  std::vector<std::string> warnings;
  (void)lens_of("stop surface 20 1 1.5 60 8 conic -1 surface inf 20 air 8", &warnings);
  REQUIRE(warnings.size() == 1); // the sag at 8 is 1.6
  CHECK_THAT(warnings[0],
             Catch::Matchers::ContainsSubstring("at 8 mm from the axis it lies 0.6 mm"));
}
