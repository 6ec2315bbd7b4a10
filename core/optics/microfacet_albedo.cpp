#include "core/optics/microfacet_albedo.h"

#include "core/optics/fresnel.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace abbe {
namespace {

/// The midpoint rule over the visible normals. The functions are even in phi, so that half of its
/// range is enough. The steep normals of a smooth surface crowd near u.y = 1, so the points lie at
/// equal steps of v with u.y = 1 - v^2, and have the weight 2 v. The sums differ from those of
/// 200 x 1600 points by less than 0.0015 for alpha from 0.0025 to 1 and eta from 1/2.4 to 2.4.
constexpr int kAround = 24, kOutwards = 96;

/// The mean of `f` over the visible normals; f returns a value that adds and scales.
template <class Function>
auto over_visible_normals(const Ggx& ggx, const dvec3& wo, Function f) {
  decltype(f(wo)) sum{};
  for (int j = 0; j < kOutwards; ++j) {
    const double v = (j + 0.5) / kOutwards;
    for (int i = 0; i < kAround; ++i)
      sum += 2.0 * v * f(ggx.sample_visible_normal(wo, {0.5 * (i + 0.5) / kAround, 1.0 - v * v}));
  }
  return sum / static_cast<double>(kAround * kOutwards);
}

dvec3 direction(double mu) {
  return {std::sqrt(1.0 - mu * mu), 0.0, mu};
}

} // namespace

double reflected_once(const Ggx& ggx, double mu) {
  const dvec3 wo = direction(mu);
  return over_visible_normals(ggx, wo,
                              [&](const dvec3& h) {
                                const dvec3 back = reflected(-wo, h);
                                return back.z > 0.0 ? ggx.g2(wo, back) : 0.0;
                              }) /
         ggx.g1(wo);
}

OnceScattered scattered_once(const Ggx& ggx, double mu, double eta) {
  const dvec3 wo = direction(mu);
  const dvec2 sum = over_visible_normals(ggx, wo, [&](const dvec3& h) {
    const double along = glm::dot(wo, h);
    const auto cos_t = refracted_cosine(along, eta);
    const double fresnel = cos_t ? fresnel_reflectance(along, *cos_t, eta) : 1.0;
    dvec2 parts(0.0);
    const dvec3 back = reflected(-wo, h);
    if (back.z > 0.0) parts.x = fresnel * ggx.g2(wo, back);
    if (!cos_t) return parts;
    const dvec3 through = refracted(-wo, h, along, *cos_t, eta);
    if (through.z < 0.0) parts.y = (1.0 - fresnel) * ggx.g2(wo, through);
    return parts;
  });
  return {sum.x / ggx.g1(wo), sum.y / ggx.g1(wo)};
}

} // namespace abbe
