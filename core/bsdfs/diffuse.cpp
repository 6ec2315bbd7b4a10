#include "core/bsdfs/diffuse.h"

#include "geometry/solids/disc_point.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace abbe {

double Diffuse::evaluate(const Incidence& in, const dvec3& wi, float* f_cos) const {
  const double pdf = wi.z / std::numbers::pi;
  const auto lambert = static_cast<float>(pdf);
  for (int b = in.bands.first; b < in.bands.last; ++b)
    f_cos[b] = in.ground[b] * lambert;
  return pdf;
}

/// Projecting the uniform points of the unit disc up to the hemisphere gives the pdf cos / pi.
std::optional<dvec3> Diffuse::sample(const Incidence&, const dvec2& u, const dvec2&) const {
  const dvec2 p = disc_point(u);
  return dvec3{p.x, p.y, std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)))};
}

} // namespace abbe
