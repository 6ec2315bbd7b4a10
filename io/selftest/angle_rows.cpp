#include "io/selftest/angle_rows.h"

#include "core/optics/fresnel.h"
#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"

#include <cmath>
#include <string>

namespace abbe {
namespace {

/// True where a ray from the middle of a box of glass leaves by the face above, at this angle.
bool leaves(const World& world, double angle_deg, double n) {
  const double a = angle_deg * kRadiansPerDegree;
  RayState state{{dvec3(0.0), dvec3(std::sin(a), std::cos(a), 0.0)}, {}, {}};
  state.nesting = world.nesting_at(state.ray.origin);
  const auto hit = world.closest(state);
  return hit && refracted_cosine(glm::dot(hit->normal, state.ray.direction), 1.0 / n).has_value();
}

/// The angle beyond which rays no longer leave the glass, by halving.
double critical_angle_deg(double n) {
  const World world({{Box{}, Transform(), MaterialId{0}, MediumId{0}, 0}}, 10.0);
  double low = 0.0, high = 44.9; // the ray has to meet the face above
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (leaves(world, middle, n) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The angle at which least of the light polarised along the plane of incidence is reflected. The
/// reflectance of unpolarised light, less half of the reflectance across, is half of that along.
double brewster_angle_deg(double n) {
  const auto along = [n](double angle_deg) {
    const double cos_i = std::cos(angle_deg * kRadiansPerDegree);
    const double cos_t = refracted_cosine(cos_i, n).value();
    const double across = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    return fresnel_reflectance(cos_i, n) - 0.5 * across * across;
  };
  double low = 10.0, high = 85.0;
  while (high - low > 1e-7) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const bool left = along(a) < along(b);
    (left ? high : low) = left ? b : a;
  }
  return 0.5 * (low + high);
}

} // namespace

SelftestRows angle_rows() {
  SelftestRows rows;
  for (const std::string glass : {"N-BK7", "N-SF11", "F2"}) {
    const double expected = expected_index(glass)[1];
    const double n = catalogue_index(glass, kGlassLines_nm[1]);
    rows.push_back({"angles", glass + ", critical angle at d", "asin(1/n)",
                    std::asin(1.0 / expected) / kRadiansPerDegree, critical_angle_deg(n), 1e-5,
                    "deg"});
    rows.push_back({"angles", glass + ", Brewster's angle at d", "atan(n)",
                    std::atan(expected) / kRadiansPerDegree, brewster_angle_deg(n), 1e-5, "deg"});
  }
  return rows;
}

} // namespace abbe
