#include "spectral/correlated_temperature.h"

#include "spectral/observer.h"
#include "spectral/radiator.h"
#include "spectral/uniform_chromaticity.h"

#include <cmath>
#include <vector>

namespace abbe {
namespace {

// Radiators lie evenly along their line by their reciprocal temperatures, in 1e-6 / K.
constexpr double kLeastMired = 10.0, kMostMired = 1000.0;
constexpr int kSteps = 198;
constexpr double kLargestDuv = 0.05;

double mired_of(int step) {
  return kLeastMired + (kMostMired - kLeastMired) * step / kSteps;
}

/// A point of the CIE 1960 diagram.
struct Uv {
  double u, v;
};

Uv uv_1960(const Chromaticity& c) {
  const UniformChromaticity uniform_1976 = uniform(c);
  return {uniform_1976.u, 2.0 / 3.0 * uniform_1976.v};
}

Uv radiator_at(double mired) {
  return uv_1960(chromaticity(to_xyz(blackbody(1e6 / mired))));
}

double distance(const Uv& a, const Uv& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

const std::vector<Uv>& radiators() {
  static const std::vector<Uv> all = [] {
    std::vector<Uv> points;
    for (int i = 0; i <= kSteps; ++i)
      points.push_back(radiator_at(mired_of(i)));
    return points;
  }();
  return all;
}

/// Where the distance is least between two reciprocal temperatures, by golden sections.
double nearest_between(const Uv& light, double low, double high) {
  const double golden = (std::sqrt(5.0) - 1.0) / 2.0;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = distance(light, radiator_at(a)), at_b = distance(light, radiator_at(b));
  constexpr double kMiredError = 1e-5; // 0.4 mK at 6500 K
  while (high - low > kMiredError) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = distance(light, radiator_at(a));
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = distance(light, radiator_at(b));
    }
  }
  return (low + high) / 2.0;
}

} // namespace

std::optional<CorrelatedTemperature> correlated_temperature(const Chromaticity& c) {
  const Uv light = uv_1960(c);
  const std::vector<Uv>& line = radiators();
  int nearest = 0;
  for (int i = 1; i <= kSteps; ++i)
    if (distance(light, line[static_cast<std::size_t>(i)]) <
        distance(light, line[static_cast<std::size_t>(nearest)]))
      nearest = i;
  if (nearest == 0 || nearest == kSteps) return std::nullopt;
  const double mired = nearest_between(light, mired_of(nearest - 1), mired_of(nearest + 1));
  const Uv radiator = radiator_at(mired);
  const double off = distance(light, radiator);
  if (!(off <= kLargestDuv)) return std::nullopt;
  return CorrelatedTemperature{1e6 / mired, light.v >= radiator.v ? off : -off};
}

} // namespace abbe
