#include "core/optics/conductor_reflectance.h"

#include <algorithm>
#include <cmath>

namespace abbe {

double conductor_reflectance(double cos_i, double n_before, double n, double k) {
  const double eta = n / n_before, kappa = k / n_before;
  const double eta2 = eta * eta, kappa2 = kappa * kappa;
  const double cos2 = cos_i * cos_i;
  if (cos2 == 0.0) return 1.0; // along the surface
  const double sin2 = 1.0 - cos2;
  // eta^2 - kappa^2 - sin^2, without cancellation where the metal is hardly denser than the medium
  const double real = (eta - 1.0) * (eta + 1.0) + cos2 - kappa2;
  // a^2 + b^2, which is never less than |real|, though the square of that may be too small a number
  const double sum = std::max(std::abs(real), std::sqrt(real * real + 4.0 * eta2 * kappa2));
  const double twice_a_cos = 2.0 * std::sqrt(std::max(0.0, 0.5 * (sum + real))) * cos_i;
  const double s = (sum - twice_a_cos + cos2) / (sum + twice_a_cos + cos2);
  if (sin2 == 0.0) return s; // both polarisations are alike
  const double across = cos2 * sum + sin2 * sin2, along = twice_a_cos * sin2;
  const double p = s * (across - along) / (across + along);
  return 0.5 * (s + p);
}

} // namespace abbe
