#include "spectral/cauchy.h"

#include "spectral/fraunhofer.h"

namespace abbe {
namespace {

double inverse_um2(double lambda_nm) {
  return 1e6 / (lambda_nm * lambda_nm);
}

} // namespace

double refractive_index(const Cauchy& law, double lambda_nm) {
  const double x = inverse_um2(lambda_nm);
  return law.a + x * (law.b_um2 + x * law.c_um4);
}

bool is_achromatic(const Cauchy& law) {
  return law.b_um2 == 0.0 && law.c_um4 == 0.0;
}

Cauchy cauchy_of_abbe(double n_d, double v_d) {
  // n_F - n_C = B (1/F^2 - 1/C^2) = (n_d - 1)/V_d.
  const double b = (n_d - 1.0) / (v_d * (inverse_um2(kLineF_nm) - inverse_um2(kLineC_nm)));
  return {n_d - b * inverse_um2(kLineD_nm), b, 0.0};
}

} // namespace abbe
