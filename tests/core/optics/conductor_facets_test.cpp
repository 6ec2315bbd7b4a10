#include "core/optics/conductor_facets.h"

#include "core/optics/conductor_reflectance.h"
#include "tests/catch.h"
#include "tests/core/scattering/directions.h"

#include <glm/geometric.hpp>

using namespace abbe;
using test::direction;

namespace {

/// A metal of two bands, gold at 450 and 650 nm, under air; or a perfect mirror.
struct Metal {
  double air[2] = {1.0, 1.0};
  float n[2] = {1.38f, 0.16f}, k[2] = {1.91f, 3.32f};
  [[nodiscard]] SurfaceOptics optics(bool fresnel = true) const {
    SurfaceOptics o;
    o.n_before = air;
    o.opaque = true;
    o.metal_n = n;
    o.metal_k = k;
    o.fresnel = fresnel;
    return o;
  }
};

double evaluate(const ConductorFacets& surface, const SurfaceOptics& optics, const dvec3& wo,
                const dvec3& wi, double* pdf = nullptr) {
  float f[2];
  const double p = evaluate_conductor_facets(surface, optics, wo, wi, {0, 2}, f);
  if (pdf) *pdf = p;
  return static_cast<double>(f[0]);
}

double furnace(const ConductorFacets& surface, const SurfaceOptics& optics, double cos_o) {
  const dvec3 wo = direction(cos_o, 0.3);
  return test::sampled_albedo(
      8000,
      [&](const dvec2& u, double choice) {
        return sample_conductor_facets(surface, wo, u, choice);
      },
      [&](const dvec3& wi) {
        double pdf = 0.0;
        const double f = evaluate(surface, optics, wo, wi, &pdf);
        return f / pdf;
      });
}

} // namespace

TEST_CASE("rough mirrors with compensation lose no light") {
  const Metal metal;
  for (const double roughness : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const GgxAlbedo albedo(ggx);
    for (const double cos_o : {1.0, 0.8, 0.5, 0.2, 0.05}) {
      INFO(roughness << ' ' << cos_o);
      CHECK(furnace({ggx, &albedo}, metal.optics(false), cos_o) == Approx(1.0).margin(0.005));
      CHECK(furnace({ggx}, metal.optics(false), cos_o) <= 1.001);
    }
  }
  CHECK(furnace({Ggx{1.0}}, metal.optics(false), 0.8) < 0.8);
}

TEST_CASE("the albedo of a rough mirror by a sum over directions is 1 too") {
  const Metal metal;
  const Ggx ggx = Ggx::from_roughness(0.7);
  const GgxAlbedo albedo(ggx);
  for (const double cos_o : {1.0, 0.5, 0.2}) {
    const dvec3 wo = direction(cos_o, 0.0);
    const ConductorFacets surface{ggx, &albedo};
    CHECK(test::sphere_integral(
              [&](const dvec3& wi) { return evaluate(surface, metal.optics(false), wo, wi); }, 0.0,
              1.0, 500) == Approx(1.0).margin(0.005));
  }
}

TEST_CASE("rough metal is the formula of its facets") {
  // F D G2 / (4 cos_o cos_i) times cos_i, with everything in tangents [Walter07; Heitz14].
  const Metal metal;
  const double alpha = 0.35;
  const auto tan2 = [](const dvec3& w) { return (1.0 - w.z * w.z) / (w.z * w.z); };
  const auto lambda = [&](const dvec3& w) {
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2(w)) - 1.0);
  };
  for (const double o : {0.9, 0.3})
    for (const double i : {0.95, 0.5, 0.1}) {
      const dvec3 wo = direction(o, 0.0), wi = direction(i, 2.5), h = glm::normalize(wo + wi);
      const double d = alpha * alpha /
                       (std::numbers::pi * std::pow(h.z, 4) * std::pow(alpha * alpha + tan2(h), 2));
      const double f = conductor_reflectance(glm::dot(wo, h), 1.0, 1.38f, 1.91f);
      CHECK(evaluate({Ggx{alpha}}, metal.optics(), wo, wi) ==
            Approx(f * d / (1.0 + lambda(wo) + lambda(wi)) / (4.0 * o)).epsilon(1e-6));
    }
}

TEST_CASE("rough metal is reciprocal") {
  const Metal metal;
  const Ggx ggx = Ggx::from_roughness(0.8);
  const GgxAlbedo albedo(ggx);
  for (const GgxAlbedo* compensation : {static_cast<const GgxAlbedo*>(nullptr), &albedo})
    for (const double o : {0.99, 0.4, 0.07})
      for (const double i : {0.9, 0.3}) {
        const dvec3 wo = direction(o, 0.2), wi = direction(i, 1.7);
        const ConductorFacets surface{ggx, compensation};
        CHECK(evaluate(surface, metal.optics(), wo, wi) / i ==
              Approx(evaluate(surface, metal.optics(), wi, wo) / o).epsilon(1e-6));
      }
}

TEST_CASE("rough metal is sampled with the pdf that it returns") {
  const Metal metal;
  for (const double roughness : {0.5, 0.8, 1.0}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const GgxAlbedo albedo(ggx);
    for (const GgxAlbedo* compensation : {static_cast<const GgxAlbedo*>(nullptr), &albedo})
      for (const double cos_o : {0.95, 0.3}) {
        INFO(roughness << ' ' << cos_o << ' ' << (compensation != nullptr));
        const ConductorFacets surface{ggx, compensation};
        const dvec3 wo = direction(cos_o, 0.5);
        CHECK(test::deviation_from_density(
                  [&](const dvec2& u, double choice) {
                    return sample_conductor_facets(surface, wo, u, choice);
                  },
                  [&](const dvec3& wi) {
                    double pdf = 0.0;
                    (void)evaluate(surface, metal.optics(), wo, wi, &pdf);
                    return pdf;
                  }) < 4.0);
      }
  }
}

TEST_CASE("polished metal reflects as a smooth one") {
  const Metal metal;
  const Ggx ggx = Ggx::from_roughness(0.03);
  const GgxAlbedo albedo(ggx);
  for (const double cos_o : {1.0, 0.6, 0.2}) {
    const double smooth = conductor_reflectance(cos_o, 1.0, 1.38f, 1.91f);
    CHECK(furnace({ggx}, metal.optics(), cos_o) == Approx(smooth).epsilon(2e-3));
    CHECK(furnace({ggx, &albedo}, metal.optics(), cos_o) == Approx(smooth).epsilon(2e-3));
  }
}

TEST_CASE("light from several facets of coloured metal is darker and more saturated") {
  const Metal metal;
  const Ggx ggx = Ggx::from_roughness(1.0);
  const GgxAlbedo albedo(ggx);
  const dvec3 wo = direction(0.7, 0.0), wi = direction(0.5, 2.0);
  float one[2], all[2];
  (void)evaluate_conductor_facets({ggx}, metal.optics(), wo, wi, {0, 2}, one);
  (void)evaluate_conductor_facets({ggx, &albedo}, metal.optics(), wo, wi, {0, 2}, all);
  CHECK(all[0] > one[0]);
  CHECK((all[0] - one[0]) / (all[1] - one[1]) < one[0] / one[1]);
}

TEST_CASE("light from several facets is a sum over the number of reflections") {
  // Each reflection after the first lets the mean albedo E of the light leave, and the metal's mean
  // reflectance F dims it: F^2 E + F^3 (1 - E) E + ..., where F = 1 gives all of it.
  const Metal metal;
  const Ggx ggx = Ggx::from_roughness(1.0);
  const GgxAlbedo albedo(ggx);
  const dvec3 wo = direction(0.7, 0.0), wi = direction(0.5, 2.0);
  const auto several = [&](const SurfaceOptics& optics) {
    return evaluate({ggx, &albedo}, optics, wo, wi) - evaluate({ggx}, optics, wo, wi);
  };
  double mean = 0.0;
  for (int i = 0; i < 1000; ++i)
    mean += conductor_reflectance(std::sqrt((i + 0.5) / 1000), 1.0, 1.38f, 1.91f) / 1000;
  double sum = 0.0, kept = mean * mean;
  for (int i = 0; i < 100; ++i, kept *= mean * (1.0 - albedo.mean()))
    sum += kept * albedo.mean();
  // The surface computes the mean reflectance by two points of Gauss's rule, which is 1 % off here.
  CHECK(several(metal.optics()) / several(metal.optics(false)) == Approx(sum).epsilon(0.03));
}

TEST_CASE("rough metal: live bands, reflectivity, and nothing below the surface") {
  const Metal metal;
  SurfaceOptics optics = metal.optics();
  const dvec3 wo = direction(0.7, 0.0), wi = direction(0.5, 2.0);
  float f[2] = {7.0f, 7.0f}, half[2], live[] = {0.0f, 1.0f};
  const double pdf = evaluate_conductor_facets({Ggx{0.4}}, optics, wo, wi, {0, 2}, f);
  CHECK(f[0] < f[1]);
  const float reflectivity[] = {0.5f, 0.25f};
  optics.reflectivity = reflectivity;
  CHECK(evaluate_conductor_facets({Ggx{0.4}}, optics, wo, wi, {0, 2, live}, half) == pdf);
  CHECK(half[0] == 0.0f);
  CHECK(half[1] == Approx(0.25 * static_cast<double>(f[1])));
  CHECK(evaluate_conductor_facets({Ggx{0.4}}, optics, wo, -wi, {0, 2}, f) == 0.0);
  CHECK(f[0] == 0.0f);
}
