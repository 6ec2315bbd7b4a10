#include "core/optics/coated_ground.h"

#include "core/optics/diffuse_fresnel.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace abbe {
namespace {

double ratio(const SurfaceOptics& optics, int b) {
  return optics.n_after[b] / optics.n_before[b];
}

/// The part of the light from a direction that the coat reflects before it reaches the ground.
double returned(const CoatedGround& surface, const SurfaceOptics& optics, double mu, int b) {
  if (!surface.rough) return optics.fractions(b, mu).reflected;
  return surface.albedo->reflected(surface.albedo->place(ratio(optics, b)), CosineTable::place(mu));
}

double mean_let_in(const CoatedGround& surface, double eta) {
  if (!surface.rough) return diffuse_transmittance(eta);
  return 1.0 - surface.albedo->mean_reflected(surface.albedo->place(eta));
}

/// The terms of one band: the ground's, the facets' and what the probability of the coat needs.
struct Shares {
  double ground_per_rho, reflectance_within, facets, returned;
};

double chance(double returned, double rho) {
  const double ground = rho * (1.0 - returned);
  return returned + ground > 0.0 ? returned / (returned + ground) : 0.0;
}

} // namespace

double coat_reflectance(const SurfaceOptics& optics, double mu, int b) {
  return optics.fractions(b, mu).reflected * optics.reflection_scale(b);
}

double coat_chance(const CoatedGround& surface, const SurfaceOptics& optics, double mu, int b) {
  return chance(returned(surface, optics, mu, b), surface.ground[b]);
}

double evaluate_coated_ground(const CoatedGround& surface, const SurfaceOptics& optics,
                              const dvec3& wo, const dvec3& wi, const BandSet& bands,
                              float* f_cos) {
  for (int b = bands.first; b < bands.last; ++b)
    f_cos[b] = 0.0f;
  if (!(wi.z > 0.0)) return 0.0;
  double facet_pdf = 0.0, seen = 0.0, cos_h = 1.0;
  if (surface.rough) {
    const dvec3 h = glm::normalize(wo + wi);
    cos_h = glm::dot(wo, h);
    facet_pdf = surface.rough->visible_pdf(wo, h) / (4.0 * cos_h);
    seen = surface.rough->g2(wo, wi) / surface.rough->g1(wo);
  }
  const auto shares = [&](int b) {
    const double eta = ratio(optics, b), out = returned(surface, optics, wo.z, b);
    const double leaves = mean_let_in(surface, eta) / (eta * eta);
    const double ground = (1.0 - out) * (1.0 - returned(surface, optics, wi.z, b)) * wi.z /
                          (std::numbers::pi * eta * eta);
    const double facets =
        surface.rough ? seen * facet_pdf * optics.fractions(b, cos_h).reflected : 0.0;
    return Shares{ground, 1.0 - leaves, facets, out};
  };
  const bool alike = optics.alike(bands.first, bands.last);
  Shares s{};
  if (alike) s = shares(bands.first);
  double pdf = 0.0;
  int count = 0;
  for (int b = bands.first; b < bands.last; ++b) {
    if (!bands.has(b)) continue;
    if (!alike) s = shares(b);
    const double rho = surface.ground[b];
    const double p = chance(s.returned, rho);
    f_cos[b] = static_cast<float>(s.facets * optics.reflection_scale(b) +
                                  rho * s.ground_per_rho / (1.0 - rho * s.reflectance_within));
    pdf += p * facet_pdf + (1.0 - p) * wi.z / std::numbers::pi;
    ++count;
  }
  return count > 0 ? pdf / count : 0.0;
}

std::optional<dvec3> sample_coated_ground(const CoatedGround& surface, const SurfaceOptics& optics,
                                          const dvec3& wo, int b, const dvec2& u, double choice) {
  if (choice >= coat_chance(surface, optics, wo.z, b)) return sample_cosine_hemisphere(u);
  if (!surface.rough) return dvec3{-wo.x, -wo.y, wo.z};
  const dvec3 h = surface.rough->sample_visible_normal(wo, u);
  const dvec3 wi = glm::normalize(2.0 * glm::dot(wo, h) * h - wo);
  if (!(wi.z > 0.0)) return std::nullopt;
  return wi;
}

} // namespace abbe
