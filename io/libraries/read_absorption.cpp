// Coloured glass, in a scene or in a material library:
//
//   absorptionTable 3  400 0.3  500 0.1  700 0   ! per mm
//   internalTransmittance 0.1 0.4 0.9 25         ! linear sRGB behind 25 mm

#include "io/libraries/read_absorption.h"

#include "io/libraries/read_dispersion.h"
#include "io/libraries/read_glass.h"
#include "spectral/band_grid.h"
#include "spectral/rgb_spectrum.h"

#include <algorithm>
#include <cmath>

namespace abbe {
namespace {

/// Less than this passes nothing that could be seen; its logarithm is still a number.
constexpr double kLeast = 1e-6;

double absorption(double transmittance, double thickness_mm) {
  return -std::log(std::clamp(transmittance, kLeast, 1.0)) / thickness_mm;
}

} // namespace

Curve read_absorption_table(Arguments& arguments) {
  Points points = read_points(arguments, kAbsorptionRange);
  return Curve::table(std::move(points.nm), std::move(points.values));
}

Curve read_internal_transmittance(Arguments& arguments) {
  constexpr Range kComponent{"a share of light that passes, linear sRGB", 0.0, 1.0};
  const double r = arguments.number(kComponent);
  const double g = arguments.number(kComponent);
  const double b = arguments.number(kComponent);
  const double thickness_mm = arguments.number({.meaning = "a thickness in mm", .open = true});
  const Curve transmittance = rgb_reflectance({r, g, b});
  if (const auto grey = transmittance.constant_value())
    return Curve::constant(absorption(*grey, thickness_mm));
  std::vector<double> values;
  for (int k = 0; k < kSampleCount; ++k)
    values.push_back(absorption(transmittance.at(sample_nm(k)), thickness_mm));
  return Curve::samples81(std::move(values));
}

} // namespace abbe
