#include "spectral/dispersion.h"

#include <limits>

namespace abbe {

double refractive_index(const Dispersion& law, double lambda_nm) {
  return std::visit([&](const auto& one) { return refractive_index(one, lambda_nm); }, law);
}

bool is_achromatic(const Dispersion& law) {
  return std::visit([](const auto& one) { return is_achromatic(one); }, law);
}

double abbe_number(const Dispersion& law) {
  if (is_achromatic(law)) return std::numeric_limits<double>::infinity();
  return (refractive_index(law, kLineD_nm) - 1.0) /
         (refractive_index(law, kLineF_nm) - refractive_index(law, kLineC_nm));
}

} // namespace abbe
