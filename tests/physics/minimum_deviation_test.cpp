#include "tests/catch.h"
#include "tests/physics/refraction.h"

#include <cmath>
#include <numbers>

using namespace abbe;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Deviation in degrees of a ray in the xz plane that enters the thesis's prism through its left
/// face at its middle, at `incidence` radians from the face's normal, and leaves through the right
/// one. The apex is at z = -2, so the ray is bent towards the base, +z.
double deviation_deg(const World& world, double incidence, double n) {
  const double h = std::numbers::sqrt3 / 2.0;
  const dvec3 outward(-h, 0.0, -0.5), along(0.5, 0.0, -h); // the left face's normal; up to the apex
  const dvec3 direction = -std::cos(incidence) * outward + std::sin(incidence) * along;
  const dvec3 entry = outward; // the foot of the normal from the middle of the prism
  const Ray out = test::through_glass(world, {entry - 5.0 * direction, direction},
                                      [n](MediumId id) { return id.valid() ? n : 1.0; });
  return std::acos(glm::dot(direction, out.direction)) / kDegree;
}

double minimum_deviation_deg(const World& world, double n) {
  // Below this incidence the ray meets the second face beyond the critical angle.
  const double least = std::asin(n * std::sin(60.0 * kDegree - std::asin(1.0 / n)));
  double low = least + 1e-6, high = 80.0 * kDegree;
  while (high - low > 1e-9) { // ternary search; the deviation has one minimum
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (deviation_deg(world, a, n) < deviation_deg(world, b, n) ? high : low) =
        deviation_deg(world, a, n) < deviation_deg(world, b, n) ? b : a;
  }
  return deviation_deg(world, 0.5 * (low + high), n);
}

} // namespace

// At minimum deviation the ray runs parallel to the base, so sin((A + delta) / 2) = n sin(A / 2):
// delta = 2 asin(n / 2) - 60 deg for A = 60 deg. The three figures are computed from Schott's
// Sellmeier coefficients, not by this program.
TEST_CASE("a 60 degree N-BK7 prism has its published minimum deviation at F, d and C") {
  const World world({{thesis_prism(), Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
  const auto at = [&](double nm) {
    return minimum_deviation_deg(world, test::glass_index("N-BK7", nm));
  };
  CHECK(at(486.1327) == Approx(39.1381).margin(1e-4));
  CHECK(at(587.5618) == Approx(38.6467).margin(1e-4));
  CHECK(at(656.2725) == Approx(38.4291).margin(1e-4));
}

TEST_CASE("red is bent least: deviation falls with wavelength over all bands") {
  const World world({{thesis_prism(), Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
  double last = 180.0;
  for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
    const double now = minimum_deviation_deg(world, test::glass_index("SF11", nm));
    CHECK(now < last);
    last = now;
  }
}
