#include "core/optics/conductor_facets.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace abbe {
namespace {

/// 2 times the integral of F(mu) mu, to about 1 %, by the two points of Gauss's rule for the weight
/// mu on [0, 1] [Abramowitz64, 25.4.33].
double mean_reflectance(const SurfaceOptics& optics, int band) {
  const double root6 = std::sqrt(6.0);
  return (0.5 - root6 / 18.0) * optics.fractions(band, 0.6 - 0.1 * root6).reflected +
         (0.5 + root6 / 18.0) * optics.fractions(band, 0.6 + 0.1 * root6).reflected;
}

/// The part that finally leaves of the light that is still among the facets after one reflection.
/// Each further reflection lets the part `mean_albedo` leave [Kulla17].
double after_several(double reflectance, double mean_albedo) {
  return reflectance * reflectance * mean_albedo / (1.0 - reflectance * (1.0 - mean_albedo));
}

} // namespace

double evaluate_conductor_facets(const ConductorFacets& surface, const SurfaceOptics& optics,
                                 const dvec3& wo, const dvec3& wi, const BandSet& bands,
                                 float* f_cos) {
  for (int b = bands.first; b < bands.last; ++b)
    f_cos[b] = 0.0f;
  if (!(wi.z > 0.0)) return 0.0;
  const dvec3 h = glm::normalize(wo + wi);
  const double cos_h = glm::dot(wo, h);
  const double once = surface.ggx.density(h) * surface.ggx.g2(wo, wi) / (4.0 * wo.z);
  double pdf = surface.ggx.visible_pdf(wo, h) / (4.0 * cos_h);
  double several = 0.0, mean_albedo = 1.0;
  if (surface.compensation) {
    const double kept = 1.0 - surface.compensation->at(wo.z);
    mean_albedo = surface.compensation->mean();
    if (mean_albedo < 1.0)
      several = kept * (1.0 - surface.compensation->at(wi.z)) * wi.z /
                (std::numbers::pi * (1.0 - mean_albedo));
    pdf = (1.0 - kept) * pdf + kept * wi.z / std::numbers::pi;
  }
  const auto value = [&](int b) {
    double f = once * optics.fractions(b, cos_h).reflected;
    if (several > 0.0) f += several * after_several(mean_reflectance(optics, b), mean_albedo);
    return f;
  };
  const bool alike = optics.alike(bands.first, bands.last);
  const double shared = alike ? value(bands.first) : 0.0;
  for (int b = bands.first; b < bands.last; ++b)
    if (bands.has(b))
      f_cos[b] = static_cast<float>((alike ? shared : value(b)) * optics.reflection_scale(b));
  return pdf;
}

std::optional<dvec3> sample_conductor_facets(const ConductorFacets& surface, const dvec3& wo,
                                             const dvec2& u, double choice) {
  if (surface.compensation && choice >= surface.compensation->at(wo.z))
    return sample_cosine_hemisphere(u);
  const dvec3 h = surface.ggx.sample_visible_normal(wo, u);
  const dvec3 wi = glm::normalize(2.0 * glm::dot(wo, h) * h - wo);
  if (!(wi.z > 0.0)) return std::nullopt;
  return wi;
}

} // namespace abbe
