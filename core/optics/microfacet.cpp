#include "core/optics/microfacet.h"

#include "geometry/solids/circle_point.h"
#include "geometry/solids/disc_point.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace abbe {

double Ggx::density(const dvec3& h) const {
  // cos^4 (1 + tan^2 / alpha^2)^2 without a difference of cosines, so that small alpha is exact
  // too.
  const double x = h.x / alpha, y = h.y / alpha;
  const double sum = x * x + y * y + h.z * h.z;
  return 1.0 / (std::numbers::pi * alpha * alpha * sum * sum);
}

double Ggx::lambda(const dvec3& w) const {
  const double x = alpha * w.x, y = alpha * w.y;
  const double across = x * x + y * y, along = w.z * w.z;
  if (along == 0.0) return std::numeric_limits<double>::infinity();
  const double tan2 = across / along;
  // (sqrt(1 + t) - 1) / 2 without cancellation.
  return 0.5 * tan2 / (1.0 + std::sqrt(1.0 + tan2));
}

double Ggx::g2(const dvec3& wo, const dvec3& wi) const {
  const double o = lambda(wo), i = lambda(wi);
  if (std::isinf(o) || std::isinf(i)) return 0.0;
  return wo.z * wi.z > 0.0 ? 1.0 / (1.0 + o + i) : std::beta(1.0 + o, 1.0 + i);
}

dvec3 Ggx::sample_visible_normal(const dvec3& wo, const dvec2& u) const {
  const dvec3 stretched = glm::normalize(dvec3{alpha * wo.x, alpha * wo.y, wo.z});
  const double from_top = u.y * (1.0 + stretched.z); // 1 - z of a point on the cap
  const double radius = std::sqrt(std::max(0.0, from_top * (2.0 - from_top)));
  const dvec3 on_cap(radius * circle_point(u.x), 1.0 - from_top);
  const dvec3 h = on_cap + stretched;
  return glm::normalize(dvec3{alpha * h.x, alpha * h.y, std::max(0.0, h.z)});
}

double Ggx::visible_pdf(const dvec3& wo, const dvec3& h) const {
  const double along = glm::dot(wo, h);
  return along > 0.0 ? density(h) * g1(wo) * along / wo.z : 0.0;
}

dvec3 sample_cosine_hemisphere(const dvec2& u) {
  const dvec2 p = disc_point(u);
  return {p.x, p.y, std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)))};
}

} // namespace abbe
