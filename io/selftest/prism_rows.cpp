#include "io/selftest/prism_rows.h"

#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace abbe {
namespace {

/// The deviation of a ray in the xz plane that enters the prism through its left face at its
/// middle, at `incidence` radians from the face's normal, and leaves through the right one. The
/// apex is at z = -2, so the ray is bent towards the base, +z.
double deviation_deg(const World& world, double incidence, double n) {
  const double h = std::numbers::sqrt3 / 2.0;
  const dvec3 outward(-h, 0.0, -0.5), along(0.5, 0.0, -h); // the left face's normal; up to the apex
  const dvec3 direction = -std::cos(incidence) * outward + std::sin(incidence) * along;
  const dvec3 entry = outward; // the foot of the normal from the middle of the prism
  const Ray out = refracted_through(world, {entry - 5.0 * direction, direction}, n).ray;
  return std::acos(glm::dot(direction, out.direction)) / kRadiansPerDegree;
}

/// At the minimum the ray runs parallel to the base, so sin((A + delta) / 2) = n sin(A / 2).
double closed_form_deg(double n) {
  return 2.0 * std::asin(0.5 * n) / kRadiansPerDegree - 60.0;
}

} // namespace

World prism_world() {
  return World({{thesis_prism(), Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
}

double minimum_deviation_deg(const World& world, double n) {
  // Below this incidence the ray meets the second face beyond the critical angle.
  const double least = std::asin(n * std::sin(60.0 * kRadiansPerDegree - std::asin(1.0 / n)));
  double low = least + 1e-6, high = 80.0 * kRadiansPerDegree;
  while (high - low > 1e-9) { // ternary search; the deviation has one minimum
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const bool left = deviation_deg(world, a, n) < deviation_deg(world, b, n);
    (left ? high : low) = left ? b : a;
  }
  return deviation_deg(world, 0.5 * (low + high), n);
}

SelftestRows prism_rows() {
  const World world = prism_world();
  SelftestRows rows;
  for (const std::string glass : {"fused-silica", "N-FK51A", "N-BK7", "N-BAK4", "F2", "N-LAK9",
                                  "SF10", "N-SF11", "N-SF6", "N-LASF9"}) {
    const auto [n_f, n_d, n_c] = expected_index(glass);
    const auto at = [&](std::size_t line) {
      return minimum_deviation_deg(world, catalogue_index(glass, kGlassLines_nm[line]));
    };
    // n has seven digits, which are 1e-5 degrees.
    rows.push_back({"prism", glass + ", minimum deviation at d", "2 asin(n/2) - 60 deg",
                    closed_form_deg(n_d), at(1), 2e-5, "deg"});
    rows.push_back({"prism", glass + ", of F less that of C", "the same",
                    closed_form_deg(n_f) - closed_form_deg(n_c), at(0) - at(2), 2e-5, "deg"});
  }
  return rows;
}

} // namespace abbe
