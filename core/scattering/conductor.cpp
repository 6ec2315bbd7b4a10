#include "core/scattering/conductor.h"

#include "core/optics/conductor_reflectance.h"

namespace abbe {

void reflect_conductor(const MaterialPlan& material, double cos_i, const double* n_before,
                       int first, int last, float* reflected) {
  const float* reflectivity = material.reflectivity.data();
  const float* n = material.metal_n.data();
  const float* k = material.metal_k.data();
  for (int b = first; b < last; ++b) {
    const double share =
        material.fresnel ? conductor_reflectance(cos_i, n_before[b], n[b], k[b]) : 1.0;
    reflected[b] = static_cast<float>(share) * reflectivity[b];
  }
}

} // namespace abbe
