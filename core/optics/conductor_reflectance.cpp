#include "core/optics/conductor_reflectance.h"

#include <algorithm>
#include <cmath>

namespace abbe {

double conductor_reflectance(double cos_i, double n_before, double n, double k) {
  const double eta2 = n * n / (n_before * n_before);
  const double kappa2 = k * k / (n_before * n_before);
  const double cos2 = cos_i * cos_i;
  const double sin2 = 1.0 - cos2;
  const double real = eta2 - kappa2 - sin2;
  const double sum = std::sqrt(real * real + 4.0 * eta2 * kappa2); // a^2 + b^2
  const double twice_a_cos = 2.0 * std::sqrt(std::max(0.0, 0.5 * (sum + real))) * cos_i;
  const double s = (sum - twice_a_cos + cos2) / (sum + twice_a_cos + cos2);
  const double across = cos2 * sum + sin2 * sin2, along = twice_a_cos * sin2;
  const double p = s * (across - along) / (across + along);
  return 0.5 * (s + p);
}

} // namespace abbe
