#include "core/optics/fresnel.h"
#include "geometry/world/world.h"
#include "io/selftest/expected_index.h"
#include "spectral/fraunhofer.h"
#include "tests/catch.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {
constexpr double kDegree = std::numbers::pi / 180.0;
const double kBk7 = catalogue_index("N-BK7", kLineD_nm);
} // namespace

// sin(critical) = 1 / n. 41.2452 deg for N-BK7 at the d line, computed outside this project.
TEST_CASE("total reflection begins at the critical angle") {
  const auto passes = [](double angle_deg) {
    return refracted_cosine(std::cos(angle_deg * kDegree), 1.0 / kBk7).has_value();
  };
  CHECK(passes(41.2451));
  CHECK_FALSE(passes(41.2453));
  CHECK(fresnel_reflectance(std::cos(41.2453 * kDegree), 1.0 / kBk7) == 1.0);
}

// A ray inside a glass box that meets a face just before or just behind the critical angle.
TEST_CASE("a ray in the world leaves glass before the critical angle and stays in behind it") {
  const World world({{Box{}, Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
  const auto leaves = [&](double angle_deg) {
    const double a = angle_deg * kDegree;
    RayState state{{dvec3(0.0), dvec3(std::sin(a), std::cos(a), 0.0)}, {}, {}};
    state.nesting = world.nesting_at(state.ray.origin);
    const auto hit = world.closest(state);
    REQUIRE(hit);
    REQUIRE(hit->normal.y == 1.0);
    return refracted_cosine(glm::dot(hit->normal, state.ray.direction), 1.0 / kBk7).has_value();
  };
  CHECK(leaves(41.2451));
  CHECK_FALSE(leaves(41.2453));
}

// At Brewster's angle, tan = n, light polarised in the plane of incidence is not reflected, so
// the mean reflectance is half of r_s^2 with r_s = -(n^2 - 1) / (n^2 + 1).
TEST_CASE("at Brewster's angle half of the perpendicular polarisation's light is reflected") {
  const double brewster = std::atan(kBk7);
  CHECK(brewster / kDegree == Approx(56.6038).margin(1e-4));
  const double rs = (kBk7 * kBk7 - 1.0) / (kBk7 * kBk7 + 1.0);
  CHECK(fresnel_reflectance(std::cos(brewster), kBk7) == Approx(0.5 * rs * rs).epsilon(1e-12));
  const auto cos_t = refracted_cosine(std::cos(brewster), kBk7);
  const double rp = (kBk7 * std::cos(brewster) - *cos_t) / (kBk7 * std::cos(brewster) + *cos_t);
  CHECK(std::abs(rp) < 1e-15);
}

// Computed outside this project: R0 = ((n-1)/(n+1))^2 = 0.042165; at 60 deg Rs, Rp follow from
// Snell's law.
TEST_CASE("Fresnel's reflectance has its closed-form values") {
  CHECK(fresnel_reflectance(1.0, kBk7) == Approx(0.042165).margin(1e-6));
  CHECK(fresnel_reflectance(1.0, 1.0 / kBk7) == Approx(0.042165).margin(1e-6));
  const double n = catalogue_index("N-BK7", 380.0);
  CHECK(fresnel_reflectance(0.5, n) ==
        Approx(0.5 * (0.188095790383 + 0.001348077240)).margin(1e-9));
  CHECK(fresnel_reflectance(0.3, 1.0) < 1e-30); // equal indices: nothing is reflected
}

TEST_CASE("refraction obeys Snell's law and is reversible") {
  for (double angle = 0.0; angle < 89.0; angle += 7.3) {
    const double a = angle * kDegree;
    const dvec3 in(std::sin(a), -std::cos(a), 0.0), normal(0.0, 1.0, 0.0);
    const auto cos_t = refracted_cosine(std::cos(a), kBk7);
    const dvec3 out = refracted(in, normal, std::cos(a), *cos_t, kBk7);
    CHECK(kBk7 * out.x == Approx(in.x).margin(1e-14));
    const auto back_cos = refracted_cosine(*cos_t, 1.0 / kBk7);
    REQUIRE(back_cos);
    const dvec3 back = refracted(-out, -normal, *cos_t, *back_cos, 1.0 / kBk7);
    CHECK(glm::distance(back, -in) < 1e-13);
  }
}
