#include "core/optics/diffuse_fresnel.h"

#include <cmath>

namespace abbe {
namespace {

/// `n` is above 1.
double walsh_reflectance(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  const double sum = n2 + 1.0, difference = n2 - 1.0, fourth = n4 - 1.0;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
         n2 * difference * difference / (sum * sum * sum) * std::log((n - 1.0) / (n + 1.0)) -
         2.0 * n * n2 * (n2 + 2.0 * n - 1.0) / (sum * fourth) +
         8.0 * n4 * (n4 + 1.0) / (sum * fourth * fourth) * std::log(n);
}

} // namespace

double diffuse_transmittance(double eta) {
  if (eta < 1.0) return eta * eta * diffuse_transmittance(1.0 / eta);
  // Rounding in the closed form grows as 2^-53 / (eta - 1)^2, while the reflectance is (eta - 1) /
  // 3 but for 4 (eta - 1)^2. Here both errors are below 1e-7.
  if (eta < 1.0 + 5e-5) return 1.0 - (eta - 1.0) / 3.0;
  return 1.0 - walsh_reflectance(eta);
}

} // namespace abbe
