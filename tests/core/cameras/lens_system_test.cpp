#include "core/cameras/lens_system.h"

#include "spectral/fraunhofer.h"
#include "tests/catch.h"
#include "tests/core/cameras/lens_file.h"

#include <array>
#include <cmath>
#include <limits>

using namespace abbe;
using test::lens_file;

namespace {

constexpr std::array kLines_nm{kLineF_nm, kLineD_nm, kLineC_nm};

struct Expected {
  const char* name;
  double mm_per_unit;
  std::array<double, 3> focal_length, back_focal_length; ///< at F, d, C, in the lens's unit
};

// Computed outside this project from the glasses' dispersion formulas, by paraxial matrices.
constexpr Expected kLenses[] = {
    {"singlet_bk7_f5", 1.0, {12.909852, 13.048086, 13.110467}, {12.466873, 12.603515, 12.665185}},
    {"planoconvex_nsf11_25",
     1.0,
     {24.711327, 25.397596, 25.684475},
     {20.836458, 21.475412, 21.742934}},
    {"achromat_cemented_laikin",
     25.4,
     {20.000540, 20.005995, 20.020487},
     {19.601867, 19.606993, 19.621261}},
    {"achromat_ac254_050_a",
     1.0,
     {50.106812, 50.166898, 50.226582},
     {43.359675, 43.444278, 43.511309}},
    {"achromat_ac254_075_a",
     1.0,
     {74.848608, 74.895938, 74.965584},
     {70.253134, 70.303005, 70.372497}},
    {"achromat_ac254_150_a",
     1.0,
     {150.003843, 149.975759, 150.069350},
     {146.160569, 146.135444, 146.229186}},
    {"telescope_doublet",
     25.4,
     {48.010903, 48.010739, 48.044180},
     {47.366506, 47.364923, 47.397666}},
    {"cooke_triplet", 1.0, {49.984083, 50.021597, 50.070087}, {42.400252, 42.436694, 42.485807}},
    {"sasian_triplet", 1.0, {49.986628, 50.000989, 50.050884}, {41.217236, 41.237649, 41.290822}},
    {"double_gauss_f2",
     1.0,
     {99.985795, 100.003721, 100.063418},
     {61.428143, 61.487503, 61.574050}},
    {"tessar_f45", 25.4, {4.002247, 3.997778, 3.998792}, {3.423909, 3.418755, 3.419538}},
    {"angenieux_double_gauss_1953",
     1.0,
     {99.874045, 99.939742, 99.965782},
     {55.776034, 55.977099, 56.056882}},
    {"zeiss_biotar_1927",
     1.0,
     {99.655738, 99.913491, 100.020759},
     {65.122530, 65.328693, 65.411713}},
    {"petzval_1900", 1.0, {85.448083, 86.190170, 86.515186}, {49.681693, 50.381842, 50.688048}},
};

/// A single glass in air, all semi-diameters alike.
LensPrescription singlet(double n, double front, double thickness, double back, double semi) {
  LensPrescription lens;
  lens.surfaces.push_back({front, thickness, ConstantIndex{n}, semi});
  lens.surfaces.push_back({back, 0.0, ConstantIndex{1.0}, semi});
  return lens;
}

/// Where a ray crosses the axis, which it meets or comes close to.
double crossing(const Ray& ray) {
  const double h2 = ray.direction.x * ray.direction.x + ray.direction.y * ray.direction.y;
  const double h = ray.origin.x * ray.direction.x + ray.origin.y * ray.direction.y;
  return ray.origin.z - h / h2 * ray.direction.z;
}

Ray reversed(const Ray& ray) {
  return {ray.at(10.0), -ray.direction};
}

} // namespace

TEST_CASE("lens system: focal and back focal lengths of all lenses at F, d and C") {
  for (const Expected& expected : kLenses) {
    INFO(expected.name);
    const LensSystem lens(lens_file(expected.name));
    for (std::size_t i = 0; i < kLines_nm.size(); ++i) {
      const ParaxialLens paraxial = lens.paraxial(kLines_nm[i]);
      CHECK(paraxial.focal_length() ==
            Approx(expected.focal_length[i] * expected.mm_per_unit).epsilon(2e-6));
      CHECK(paraxial.back_focal_length() ==
            Approx(expected.back_focal_length[i] * expected.mm_per_unit).epsilon(2e-6));
    }
  }
}

TEST_CASE("lens system: exact rays close to the axis meet at the paraxial focus") {
  for (const Expected& expected : kLenses) {
    INFO(expected.name);
    const LensSystem lens(lens_file(expected.name));
    for (std::size_t i = 0; i < kLines_nm.size(); ++i) {
      // Spherical aberration goes as the square of the height: 1e-6 of f and a factor.
      const double height = 1e-3 * expected.focal_length[i] * expected.mm_per_unit;
      const auto n = lens.indices(kLines_nm[i]);
      const auto out = lens.trace_from_object({{height, 0, -1}, {0, 0, 1}}, n);
      REQUIRE(out);
      CHECK(crossing(out->ray) - lens.last_vertex() ==
            Approx(expected.back_focal_length[i] * expected.mm_per_unit).epsilon(1e-4));
    }
  }
}

TEST_CASE("lens system: the singlet's focus moves with the wavelength by the known amount") {
  const LensSystem lens(lens_file("singlet_bk7_f5"));
  const auto focus = [&](double nm) {
    const auto out = lens.trace_from_object({{0, 1e-3, -1}, {0, 0, 1}}, lens.indices(nm));
    return crossing(out.value().ray);
  };
  CHECK(focus(kLineF_nm) - focus(kLineC_nm) == Approx(-0.198312).epsilon(1e-4));
}

TEST_CASE("lens system: Newton's formula and the principal planes") {
  const LensSystem lens(lens_file("double_gauss_f2"));
  const ParaxialLens p = lens.paraxial(kLineD_nm);
  const double f = p.focal_length();
  CHECK(p.a * p.d - p.b * p.c == Approx(1.0).epsilon(1e-12));
  for (const double s : {150.0, 300.0, 1e4}) {
    const double v = p.image_distance(s);
    CHECK((s + p.front_focal_length()) * (v - p.back_focal_length()) ==
          Approx(f * f).epsilon(1e-9));
    CHECK(p.object_distance(v) == Approx(s).epsilon(1e-9));
    // From the principal planes, 1/s + 1/v = 1/f and the magnification is v / s.
    const double from_h = s + p.front_principal_plane(), to_h = v - p.rear_principal_plane();
    CHECK(1.0 / from_h + 1.0 / to_h == Approx(1.0 / f).epsilon(1e-9));
    CHECK(p.height_per_slope(v) / s == Approx(to_h / from_h).epsilon(1e-9));
  }
  CHECK(p.image_distance(std::numeric_limits<double>::infinity()) == p.back_focal_length());
  CHECK(p.front_focal_length() == Approx(-29.3208).epsilon(1e-5)); // CODE V's listing
}

TEST_CASE("lens system: an aplanatic lens images its point exactly at any height") {
  // A sphere of radius R images the point at R (1 + n) behind its vertex to R (1 + 1 / n) without
  // aberration; a second surface about that point lets all rays pass straight.
  const double n = 1.6, r = 10.0, t = 2.0, image = r * (1.0 + 1.0 / n);
  const LensSystem lens(singlet(n, r, t, image - t, 8.0));
  const dvec3 object{0, 0, r * (1.0 + n)};
  for (const double height : {0.1, 2.0, 5.0, 7.5}) {
    const dvec3 from{0.6 * height, 0.8 * height, -1.0};
    const auto out =
        lens.trace_from_object({from, glm::normalize(object - from)}, lens.indices(500.0));
    REQUIRE(out);
    CHECK(crossing(out->ray) == Approx(image).epsilon(1e-12));
  }
}

TEST_CASE("lens system: a ray sent back takes the same way") {
  for (const char* name : {"double_gauss_f2", "petzval_1900", "tessar_f45"}) {
    const LensSystem lens(lens_file(name));
    const auto n = lens.indices(450.0);
    const Ray ray{{3.0, -4.0, -20.0}, glm::normalize(dvec3(-0.05, 0.08, 1.0))};
    const auto out = lens.trace_from_object(ray, n);
    REQUIRE(out);
    const auto back = lens.trace_from_film(reversed(out->ray), n);
    REQUIRE(back);
    CHECK(glm::distance(back->ray.direction, -ray.direction) < 1e-12);
    const double way = glm::dot(back->ray.origin - ray.origin, ray.direction);
    CHECK(glm::distance(back->ray.origin, ray.at(way)) < 1e-12);
  }
}

TEST_CASE("lens system: rays outside a clear aperture, or the wrong way round, are stopped") {
  LensPrescription prescription = singlet(1.5, 50.0, 3.0, -50.0, 8.0);
  prescription.surfaces[1].semi_diameter_mm = 6.0;
  const LensSystem lens(prescription);
  const auto n = lens.indices(500.0);
  const auto passes = [&](double height) {
    return lens.trace_from_film({{0, height, 10}, {0, 0, -1}}, n).has_value();
  };
  CHECK(passes(5.999));
  CHECK_FALSE(passes(6.001));
  CHECK_FALSE(lens.trace_from_film({{0, 0, 10}, {0, 0, 1}}, n));
  CHECK_FALSE(lens.trace_from_object({{0, 0, -10}, {0, 0, -1}}, n));
  CHECK_FALSE(lens.trace_from_film({{0, 0, 10}, {0, 1, 0}}, n));
  CHECK_FALSE(lens.trace_from_film({{0, 60, 10}, {0, 0, -1}}, n)); // misses the sphere
}

TEST_CASE("lens system: total reflection inside stops a ray") {
  // Flat in front, a ball behind: at height h a ray along the axis meets the ball at sin i = h / R
  // and is caught for n h / R > 1.
  const LensSystem lens(singlet(1.5, 0.0, 10.0, -10.0, 9.9));
  const auto n = lens.indices(500.0);
  CHECK(lens.trace_from_object({{0, 6.6, -1}, {0, 0, 1}}, n));
  CHECK_FALSE(lens.trace_from_object({{0, 6.7, -1}, {0, 0, 1}}, n));
}

TEST_CASE("lens system: a ray where the surfaces have crossed is stopped") {
  // Balls of radius 10 whose vertices are 1 apart meet at height sqrt(100 - 9.5^2) = 3.12.
  const LensSystem lens(singlet(1.5, 10.0, 1.0, -10.0, 6.0));
  const auto n = lens.indices(500.0);
  CHECK(lens.trace_from_object({{0, 3.0, -1}, {0, 0, 1}}, n));
  CHECK_FALSE(lens.trace_from_object({{0, 3.2, -1}, {0, 0, 1}}, n));
}

TEST_CASE("lens system: uncoated surfaces reflect what Fresnel's equations say") {
  const LensSystem lens(singlet(1.5, 50.0, 3.0, -50.0, 8.0));
  const auto n = lens.indices(500.0);
  const Ray axis{{0, 0, 10}, {0, 0, -1}};
  CHECK(lens.trace_from_film(axis, n)->transmittance == 1.0);
  CHECK(lens.trace_from_film(axis, n, true)->transmittance ==
        Approx(0.96 * 0.96).epsilon(1e-12)); // ((n - 1) / (n + 1))^2 = 0.04
}

TEST_CASE("lens system: the f-number sizes the stop and the surfaces") {
  const LensSystem lens(lens_file("double_gauss_f2"));
  CHECK(lens.entrance_pupil_diameter() == Approx(50.0).epsilon(1e-4)); // as its source says
  CHECK(lens.surfaces()[lens.stop()].semi_diameter < 25.0);
  for (const auto& surface : lens.surfaces())
    CHECK(surface.semi_diameter > 15.0);
  // A stop in front of all glass is as wide as the beam.
  const LensSystem doublet(lens_file("telescope_doublet"));
  CHECK(2.0 * doublet.surfaces()[0].semi_diameter == Approx(48.010739 * 25.4 / 8.0).epsilon(1e-6));
}

TEST_CASE("lens system: a field widens the surfaces away from the stop") {
  LensPrescription narrow = lens_file("cooke_triplet"), wide = narrow;
  narrow.half_field_deg = 0.0;
  const LensSystem a(narrow), b(wide);
  CHECK(a.surfaces()[0].semi_diameter == Approx(5.0).epsilon(1e-3)); // f/5 of 50 mm
  CHECK(b.surfaces()[0].semi_diameter > a.surfaces()[0].semi_diameter + 1.0);
  CHECK(b.surfaces()[b.stop()].semi_diameter == a.surfaces()[a.stop()].semi_diameter);
}

TEST_CASE("lens system: stopping down") {
  LensSystem lens(lens_file("zeiss_biotar_1927"));
  const double open = lens.entrance_pupil_diameter();
  lens.set_entrance_pupil_diameter(12.5);
  CHECK(lens.entrance_pupil_diameter() == Approx(12.5).epsilon(1e-9));
  LensSystem other(lens_file("zeiss_biotar_1927"));
  CHECK_THROWS_WITH(other.set_entrance_pupil_diameter(1.01 * open),
                    Catch::Matchers::ContainsSubstring("it opens to f/"));
  CHECK_NOTHROW(other.set_entrance_pupil_diameter(open));
}

TEST_CASE("lens system: what is no lens is refused") {
  const auto refused = [](const LensPrescription& lens, const char* why) {
    CHECK_THROWS_WITH(LensSystem(lens), Catch::Matchers::ContainsSubstring(why));
  };
  refused({}, "it has no surface");
  LensPrescription lens = singlet(1.5, 50.0, 3.0, -50.0, 8.0);
  lens.stop = 2;
  refused(lens, "it has no stop");
  refused(singlet(1.5, -50.0, 3.0, 50.0, 8.0), "its focal length is not positive");
  refused(singlet(1.5, 0.0, 3.0, 0.0, 8.0), "its focal length is not positive");
  lens = singlet(1.5, 50.0, 3.0, -50.0, 8.0);
  lens.surfaces[1].medium_after = ConstantIndex{1.3};
  refused(lens, "no air behind its last surface");
  lens = singlet(1.5, 50.0, 3.0, -50.0, 8.0);
  lens.surfaces[0].semi_diameter_mm.reset();
  refused(lens, "its stop has no semi-diameter");
  lens.f_number = 0.1;
  refused(lens, "it cannot be opened to its f-number");
  // Behind a sphere of radius 1 and index 2 the focus is 2 away.
  lens = {};
  lens.surfaces = {{1.0, 2.0, ConstantIndex{2.0}, {}}, {0.0, 0.0, ConstantIndex{1.0}, 0.5}};
  lens.stop = 1;
  refused(lens, "its stop lies at the focus of the surfaces before it");
  lens = singlet(1.5, 50.0, 3.0, 0.0, 8.0);
  lens.surfaces[1].semi_diameter_mm = 2.0;
  lens.surfaces.push_back({0.0, 0.0, ConstantIndex{1.0}, {}});
  refused(lens, "the beam through its stop does not come through it");
}
