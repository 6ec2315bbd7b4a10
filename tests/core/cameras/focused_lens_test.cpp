#include "core/cameras/focused_lens.h"

#include "spectral/fraunhofer.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <cmath>
#include <limits>

using namespace abbe;
using test::lens_file;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

RealLens lens_with(const char* name, double focus_distance) {
  RealLens lens{lens_file(name)};
  lens.focus_distance = focus_distance;
  return lens;
}

FocusedLens focused(const RealLens& lens, double mm_per_unit = 1.0) {
  return focused_lens(lens, Camera{}, mm_per_unit);
}

} // namespace

TEST_CASE("focused lens: at infinity the film is at the back focus of the d line") {
  const FocusedLens lens = focused(lens_with("double_gauss_f2", kInfinite));
  CHECK(lens.film_distance == Approx(61.487503).epsilon(1e-6));
  CHECK(lens.focus_distance == kInfinite);
}

TEST_CASE("focused lens: nearer, the film moves back by Newton's formula") {
  const double f = 100.003721, s = 1000.0;
  const FocusedLens lens = focused(lens_with("double_gauss_f2", s));
  const double front_focus = lens.lens.paraxial(kLineD_nm).front_focal_length();
  CHECK(lens.film_distance - 61.487503 == Approx(f * f / (s + front_focus)).epsilon(1e-5));
  // The same in a scene whose unit is the metre.
  CHECK(focused(lens_with("double_gauss_f2", 1.0), 1000.0).film_distance ==
        Approx(lens.film_distance).epsilon(1e-12));
}

TEST_CASE("focused lens: a film distance says where the focus is") {
  const double film = focused(lens_with("double_gauss_f2", 700.0)).film_distance;
  RealLens real = lens_with("double_gauss_f2", kInfinite);
  real.film_distance_mm = film;
  CHECK(focused(real).focus_distance == Approx(700.0).epsilon(1e-9));
  real.film_distance_mm = 60.0; // nearer than the back focus: nothing real is sharp
  CHECK(focused(real).focus_distance == kInfinite);
}

TEST_CASE("focused lens: the film is as tall as the field of view asks") {
  RealLens real = lens_with("double_gauss_f2", kInfinite);
  Camera camera;
  camera.field_of_view_deg = 20.0;
  const FocusedLens lens = focused_lens(real, camera, 1.0);
  CHECK(lens.film_height ==
        Approx(2.0 * 100.003721 * std::tan(10.0 * 3.141592653589793 / 180.0)).epsilon(1e-6));
  CHECK(lens.image_slope() == Approx(lens.film_height / 100.003721).epsilon(1e-6));
  real.film_height_mm = 24.0;
  CHECK(focused_lens(real, camera, 1.0).film_height == 24.0);
  CHECK(focused_lens(real, camera, 1.0).image_slope() == Approx(24.0 / 100.003721).epsilon(1e-6));
}

TEST_CASE("focused lens: the aperture is given in scene units") {
  RealLens real = lens_with("double_gauss_f2", kInfinite);
  real.aperture = 2.5;
  CHECK(focused(real, 10.0).lens.entrance_pupil_diameter() == Approx(25.0).epsilon(1e-9));
}

TEST_CASE("focused lens: what no lens can do is refused") {
  const auto refused = [](const RealLens& lens, const char* why) {
    CHECK_THROWS_WITH(focused(lens), Catch::Matchers::ContainsSubstring(why));
  };
  RealLens real = lens_with("double_gauss_f2", kInfinite);
  real.aperture = 60.0;
  refused(real, "it opens to f/2.00 only");
  refused(lens_with("double_gauss_f2", 25.0), "no image of what is nearer than 29.32 mm");
  real = lens_with("double_gauss_f2", kInfinite);
  real.film_distance_mm = -1.0;
  refused(real, "the film would stand in its glass");
  // A hollow last surface, whose rim reaches 10 - sqrt(10^2 - 6^2) = 2 mm towards the film.
  LensPrescription hollow;
  hollow.surfaces = {{5.0, 4.0, ConstantIndex{1.5}, 4.5}, {10.0, 0.0, ConstantIndex{1.0}, 6.0}};
  real = RealLens{hollow};
  real.film_distance_mm = 1.9;
  refused(real, "the film would stand in its glass");
  real.film_distance_mm = 2.1;
  CHECK_NOTHROW(focused(real));
  // A rod with round ends, with an image inside: ((n - 1) / R = 0.05 per mm) d = 1 - 0.05 t / n <
  // 0, and a ray through its first vertex comes back to the axis t / n / -d = 320 mm behind it.
  LensPrescription rod;
  rod.surfaces = {{10.0, 32.0, ConstantIndex{1.5}, 2.0}, {-10.0, 0.0, ConstantIndex{1.0}, 2.0}};
  real = RealLens{rod};
  real.film_distance_mm = 319.0;
  CHECK_NOTHROW(focused(real));
  real.film_distance_mm = 321.0;
  refused(real, "no field of view fits its film there; filmHeight is needed");
  real.film_height_mm = 1.0;
  CHECK_NOTHROW(focused(real));
}
