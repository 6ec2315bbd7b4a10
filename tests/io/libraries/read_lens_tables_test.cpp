#include "io/libraries/read_lens_tables.h"

#include "core/cameras/lens_system.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"

using namespace abbe;

namespace {

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const ReadError& error) {
    return error.what();
  }
  return "no error";
}

// A plano-convex singlet as Zemax writes one: R = 10 mm, BK7, and a plane before it.
std::string zmx(const std::string& front = "  TYPE STANDARD\n") {
  return "VERS 191028\nMODE SEQ\nUNIT MM X W X CM MR CPMM\nFNUM 4 0\nSURF 0\n  TYPE STANDARD\n"
         "  CURV 0\n  DISZ INFINITY\nSURF 1\n  TYPE STANDARD\n  CURV 0\n  DISZ 3\nSURF 2\n  "
         "STOP\n" +
         front +
         "  CURV 0.1 0 0 0 0 \"\"\n  DISZ 2\n  GLAS N-BK7 0 0 1.5168 64.17\n  DIAM 4 1 0 0 1 \"\"\n"
         "SURF 3\n  TYPE STANDARD\n  CURV 0\n  DISZ 18\n  DIAM 4\nSURF 4\n  TYPE STANDARD\n"
         "  CURV 0\n  DISZ 0\n";
}

} // namespace

TEST_CASE("a lens of Zemax is read from the stop to the last glass") {
  const LensPrescription lens = read_zmx_text(zmx(), "singlet.zmx");
  CHECK(lens.name == "singlet");
  REQUIRE(lens.surfaces.size() == 2);
  CHECK(lens.stop == 0);
  CHECK(lens.surfaces[0].semi_diameter_mm == 4.0);
  // A plano-convex lens: f = R / (n - 1).
  CHECK(LensSystem(lens).paraxial(kLineD_nm).focal_length() == Approx(10.0 / 0.5168).epsilon(1e-5));
}

TEST_CASE("aspheres and unknown glasses of Zemax bring their numbers") {
  const LensPrescription lens = read_zmx_text(
      zmx("  TYPE EVENASPH\n  CONI -0.5\n  PARM 1 0\n  PARM 2 1.1e-5\n  PARM 3 -2e-9\n"), "a.zmx");
  CHECK(lens.surfaces[0].conic == -0.5);
  CHECK(lens.surfaces[0].even_terms == std::vector{0.0, 1.1e-5, -2e-9});
  std::string text = zmx();
  text.replace(text.find("N-BK7"), 5, "XX-99");
  const LensPrescription model = read_zmx_text(text, "a.zmx");
  CHECK(refractive_index(model.surfaces[0].medium_after, kLineD_nm) == Approx(1.5168));
  CHECK(abbe_number(model.surfaces[0].medium_after) == Approx(64.17));
}

TEST_CASE("a lens in inches is as large as it is") {
  std::string text = zmx("  TYPE EVENASPH\n  PARM 2 1e-3\n");
  text.replace(text.find("UNIT MM"), 7, "UNIT IN");
  const LensPrescription lens = read_zmx_text(text, "a.zmx");
  CHECK(lens.surfaces[0].radius_mm == Approx(254.0));
  CHECK(lens.surfaces[0].thickness_mm == Approx(50.8));
  CHECK(lens.surfaces[0].even_terms[1] == Approx(1e-3 / (25.4 * 25.4 * 25.4)));
}

TEST_CASE("pbrt's lens table is read") {
  const LensPrescription lens = read_dat_text("# radius thickness eta diameter\n"
                                              "10 2 1.5 8\n\n0 1 0 6\n-30 20 1.5 8\n-10 0 1 8\n",
                                              "l.dat");
  REQUIRE(lens.surfaces.size() == 4);
  CHECK(lens.stop == 1);
  CHECK(lens.surfaces[1].semi_diameter_mm == 3.0);
  CHECK(lens.surfaces[1].medium_after == Dispersion(ConstantIndex{1.0}));
}

TEST_CASE("what is wrong with a lens file of another program is told at its line") {
  CHECK(error_of([] { (void)read_zmx_text(zmx("  TYPE TOROIDAL\n"), "a.zmx"); }) ==
        "a.zmx:15:1: a surface of the type TOROIDAL is not read (spheres, conics and even aspheres "
        "are (STANDARD and EVENASPH)). Replace it by one of these");
  CHECK(error_of([] {
          (void)read_zmx_text("UNIT MM\n", "a.zmx");
        }).starts_with("a.zmx:1:1: the file holds no lens with a stop"));
  CHECK(error_of([] { (void)read_dat_text("10 2 1.5\n", "l.dat"); }) ==
        "l.dat:1:1: a number is missing (it is word 4). Save the lens again");
  CHECK(error_of([] {
          (void)read_dat_text("10 2 x 8\n", "l.dat");
        }).starts_with("l.dat:1:1: \"x\" is not a number"));
}
