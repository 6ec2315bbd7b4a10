#include "core/materials/dielectric.h"

#include "core/materials/fresnel.h"

#include <algorithm>

namespace abbe {

void scatter_dielectric(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, DielectricScatter& scatter) {
  const float* reflectivity = material.reflectivity.data();
  const float* transparency = material.transparency.data();
  const double sin2_i = 1.0 - cos_i * cos_i;
  for (int b = first; b < last; ++b) {
    const double eta = n_after[b] / n_before[b];
    const double cos2_t = 1.0 - sin2_i / (eta * eta);
    const bool passes = cos2_t > 0.0;
    const double cos_t = std::sqrt(std::max(cos2_t, 0.0));
    const double fresnel = passes ? fresnel_reflectance(cos_i, cos_t, eta) : 1.0;
    const auto reflect = material.fresnel ? fresnel : 1.0;
    const auto transmit = material.fresnel ? 1.0 - fresnel : (passes ? 1.0 : 0.0);
    const auto i = static_cast<std::size_t>(b);
    scatter.reflected[i] = static_cast<float>(reflect) * reflectivity[b];
    scatter.transmitted[i] = static_cast<float>(transmit / (eta * eta)) * transparency[b];
  }
}

void attenuate_straight(const MaterialPlan& material, double cos_i, const double* n_before,
                        const double* n_after, int first, int last, float* transmittance) {
  const float* transparency = material.transparency.data();
  for (int b = first; b < last; ++b) {
    const double eta = n_after[b] / n_before[b];
    const double passed =
        material.fresnel ? 1.0 - fresnel_reflectance(cos_i, std::max(eta, 1.0 / eta)) : 1.0;
    transmittance[b] *= static_cast<float>(passed) * transparency[b];
  }
}

} // namespace abbe
