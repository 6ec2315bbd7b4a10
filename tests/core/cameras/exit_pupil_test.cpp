#include "core/cameras/exit_pupil.h"

#include "core/sampling/sampler.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

using namespace abbe;
using test::lens_file;

namespace {

FocusedLens focused(const char* name, double f_number = 0.0) {
  RealLens lens{lens_file(name)};
  lens.focus_distance = 5000.0;
  lens.film_height_mm = 24.0;
  if (f_number > 0.0)
    lens.aperture = LensSystem(lens.prescription).paraxial(587.5618).focal_length() / f_number;
  return focused_lens(lens, Camera{}, 1.0);
}

bool passes(const FocusedLens& f, double film_radius, const dvec2& pupil, double lambda_nm) {
  const dvec3 from{film_radius, 0.0, f.lens.last_vertex() + f.film_distance};
  const dvec3 to{pupil.x, pupil.y, f.lens.last_vertex()};
  return f.lens.trace_from_film({from, glm::normalize(to - from)}, f.lens.indices(lambda_nm))
      .has_value();
}

bool holds(const PupilEllipse& e, const dvec2& p) {
  const dvec2 q = (p - dvec2(e.center, 0.0)) / e.semi_axes;
  return q.x * q.x + q.y * q.y <= 1.0;
}

} // namespace

TEST_CASE("exit pupil: its ellipses hold every ray that passes, and few others") {
  struct Case {
    const char* name;
    double f_number, film_radius;
  };
  for (const Case& c : {Case{"double_gauss_f2", 0.0, 25.0}, Case{"double_gauss_f2", 8.0, 25.0},
                        Case{"zeiss_biotar_1927", 0.0, 30.0}, Case{"singlet_bk7_50", 0.0, 20.0},
                        Case{"cooke_triplet", 64.0, 20.0}, Case{"petzval_1900", 0.0, 30.0}}) {
    INFO(c.name << " " << c.f_number);
    const FocusedLens lens = focused(c.name, c.f_number);
    const ExitPupil pupil(lens, c.film_radius);
    const double reach = 1.5 * lens.lens.surfaces().back().semi_diameter + c.film_radius;
    int found = 0, missed = 0, tried = 0, passed = 0;
    for (std::uint32_t i = 0; i < 8000; ++i) {
      const Sampler sampler(1, 2, i, 3);
      const dvec2 u = sampler.pair(0), v = sampler.pair(1), w = sampler.pair(2);
      const double r = c.film_radius * u.x, nm = 377.5 + 405.0 * u.y;
      const PupilEllipse* ellipse = pupil.at(r);
      // Anywhere on the last surface, and beyond.
      const dvec2 anywhere = reach * (2.0 * v - 1.0);
      if (passes(lens, r, anywhere, nm)) {
        ++found;
        missed += !ellipse || !holds(*ellipse, anywhere);
      }
      if (!ellipse) continue;
      const double angle = 2.0 * std::numbers::pi * w.y;
      const dvec2 inside =
          dvec2(ellipse->center, 0.0) +
          std::sqrt(w.x) * ellipse->semi_axes * dvec2(std::cos(angle), std::sin(angle));
      ++tried;
      passed += passes(lens, r, inside, nm);
    }
    CHECK(missed == 0);
    if (c.f_number == 0.0) CHECK(found > 50);
    CHECK(passed > 0.8 * tried);
  }
}

TEST_CASE("exit pupil: on the axis it is a disc, of which nearly all passes") {
  const FocusedLens lens = focused("double_gauss_f2", 4.0);
  const ExitPupil pupil(lens, 20.0);
  const PupilEllipse* axial = pupil.at(0.0);
  REQUIRE(axial);
  CHECK(axial->semi_axes.x == Approx(axial->semi_axes.y).epsilon(0.02));
  CHECK(std::abs(axial->center) < 0.02 * axial->semi_axes.x);
}

// A lens free of coma and spherical aberration obeys the sine condition: for an object far away the
// widest ray meets the film at sin = D / (2 f).
TEST_CASE("exit pupil: the light in the middle is that of the f-number") {
  RealLens lens{lens_file("double_gauss_f2")};
  lens.focus_distance = 1e7;
  lens.aperture = 100.003721 / 4.0;
  const ExitPupil pupil(focused_lens(lens, Camera{}, 1.0), 20.0);
  CHECK(pupil.axial_irradiance() == Approx(std::numbers::pi / (4.0 * 16.0)).epsilon(2e-3));
}

TEST_CASE("exit pupil: far from the axis no light comes") {
  const ExitPupil pupil(focused("double_gauss_f2"), 200.0);
  CHECK(pupil.at(20.0));
  CHECK_FALSE(pupil.at(100.0));
  CHECK_FALSE(pupil.at(200.0));
  CHECK_FALSE(pupil.at(250.0));
  // It shrinks on the way there.
  CHECK(pupil.at(40.0)->area() < 0.8 * pupil.at(0.0)->area());
}
