#include "spectral/radiator.h"

#include "spectral/band_grid.h"
#include "spectral/data_table.h"
#include "spectral/observer.h"

#include <cmath>
#include <stdexcept>

namespace abbe {
namespace {

Curve scaled_to_unit_luminance(std::vector<double> values) {
  const Curve samples = Curve::samples81(std::move(values));
  return samples.scaled(1.0 / to_xyz(samples).y);
}

double round_to_thousandths(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

// Chromaticity of daylight on the CIE's locus [CIE15].
Chromaticity daylight_chromaticity(double kelvin) {
  const double u = 1000.0 / kelvin;
  const double x = kelvin <= 7000.0 ? 0.244063 + u * (0.09911 + u * (2.9678 - u * 4.6070))
                                    : 0.237040 + u * (0.24748 + u * (1.9018 - u * 2.0064));
  return {x, -3.000 * x * x + 2.870 * x - 0.275};
}

} // namespace

Curve blackbody(double kelvin) {
  if (!std::isfinite(kelvin) || kelvin <= 0.0)
    throw std::invalid_argument("a blackbody needs a temperature above 0 K");
  // Second radiation constant h c / k, in nm K [CODATA18].
  constexpr double c2_nm_k = 6.62607015e-34 * 299792458.0 / 1.380649e-23 * 1e9;
  // Planck's law relative to its value at 780 nm, written so that no exponential overflows:
  // (l0/l)^5 (e^x0 - 1)/(e^x - 1) with x = c2/(l T).
  const double reference_nm = sample_nm(kSampleCount - 1);
  const double x0 = c2_nm_k / (reference_nm * kelvin);
  std::vector<double> values(kSampleCount);
  for (int k = 0; k < kSampleCount; ++k) {
    const double x = c2_nm_k / (sample_nm(k) * kelvin);
    values[k] = std::pow(reference_nm / sample_nm(k), 5.0) * std::exp(x0 - x) * std::expm1(-x0) /
                std::expm1(-x);
  }
  return scaled_to_unit_luminance(std::move(values));
}

Curve cie_daylight(double kelvin) {
  if (!std::isfinite(kelvin) || kelvin < 4000.0 || kelvin > 25000.0)
    throw std::invalid_argument("daylight is defined from 4000 to 25000 K");
  const Chromaticity c = daylight_chromaticity(kelvin);
  const double m = 0.0241 + 0.2562 * c.x - 0.7341 * c.y;
  const double m1 = round_to_thousandths((-1.3515 - 1.7703 * c.x + 5.9114 * c.y) / m);
  const double m2 = round_to_thousandths((0.0300 - 31.4424 * c.x + 30.0717 * c.y) / m);
  const DataTable basis{embedded_table("cie_daylight_basis.csv")};
  const std::vector<double> nm = basis.numbers("nm");
  const Curve s0 = Curve::table(nm, basis.numbers("S0"));
  const Curve s1 = Curve::table(nm, basis.numbers("S1"));
  const Curve s2 = Curve::table(nm, basis.numbers("S2"));
  std::vector<double> values(kSampleCount);
  for (int k = 0; k < kSampleCount; ++k)
    values[k] = s0.at(sample_nm(k)) + m1 * s1.at(sample_nm(k)) + m2 * s2.at(sample_nm(k));
  return scaled_to_unit_luminance(std::move(values));
}

} // namespace abbe
