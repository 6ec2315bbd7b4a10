#include "core/bsdfs/diffuse.h"

#include "core/optics/microfacet.h"

#include <numbers>

namespace abbe {

double Diffuse::evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const {
  const double pdf = wi.z / std::numbers::pi;
  const auto lambert = static_cast<float>(pdf);
  for (int b = in.bands.first; b < in.bands.last; ++b)
    f_cos[b] = in.ground[b] * lambert;
  return pdf;
}

std::optional<dvec3> Diffuse::sample(const Incidence&, const dvec2& u, const dvec2&) const {
  return sample_cosine_hemisphere(u);
}

} // namespace abbe
