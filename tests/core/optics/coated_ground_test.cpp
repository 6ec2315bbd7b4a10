#include "core/optics/coated_ground.h"

#include "core/optics/diffuse_fresnel.h"
#include "core/optics/fresnel.h"
#include "tests/catch.h"
#include "tests/core/scattering/directions.h"

using namespace abbe;
using test::direction;

namespace {

struct Plastic {
  double before[2] = {1.0, 1.0}, coat[2];
  float ground[2];
  Plastic(double n, float rho0, float rho1) : coat{n, n + 0.1}, ground{rho0, rho1} {}
  [[nodiscard]] SurfaceOptics optics() const {
    SurfaceOptics o;
    o.n_before = before;
    o.n_after = coat;
    return o;
  }
};

struct Scatter {
  double f[2], pdf;
};

Scatter evaluate(const CoatedGround& surface, const SurfaceOptics& optics, const dvec3& wo,
                 const dvec3& wi) {
  float f[2] = {};
  Scatter s{};
  s.pdf = evaluate_coated_ground(surface, optics, wo, wi, {0, 2}, f);
  std::copy(f, f + 2, s.f);
  return s;
}

double furnace(const CoatedGround& surface, const SurfaceOptics& optics, const dvec3& wo,
               int band) {
  return test::sampled_albedo(
      16000,
      [&](const dvec2& u, double choice) {
        const int b = choice < 0.5 ? 0 : 1;
        return sample_coated_ground(surface, optics, wo, b, u, 2.0 * choice - b);
      },
      [&](const dvec3& wi) {
        if (!surface.rough && wi.x == -wo.x && wi.y == -wo.y) return 0.0; // the mirror direction
        const Scatter s = evaluate(surface, optics, wo, wi);
        return s.f[band] / s.pdf;
      });
}

} // namespace

TEST_CASE("Fresnel's mean over a hemisphere agrees with a sum and a published value") {
  for (const double eta : {1.0, 1.000001, 1.0003, 1.05, 1.33, 1.5, 2.4, 0.75, 1.0 / 1.5, 0.4}) {
    double sum = 0.0; // midpoints in mu^2
    for (int i = 0; i < 400000; ++i)
      sum += 1.0 - fresnel_reflectance(std::sqrt((i + 0.5) / 400000), eta);
    CHECK(diffuse_transmittance(eta) == Approx(sum / 400000).margin(5e-6));
  }
  CHECK(1.0 - diffuse_transmittance(1.5) == Approx(0.0918).margin(5e-5)); // [Judd42]
  CHECK(1.0 - diffuse_transmittance(1.0 / 1.5) == Approx(0.5963).margin(5e-5));
}

TEST_CASE("white plastic loses no light") {
  for (const double n : {1.33, 1.5, 2.4}) {
    const Plastic plastic(n, 1.0f, 1.0f);
    const SurfaceOptics optics = plastic.optics();
    for (const double cos_o : {1.0, 0.6, 0.2, 0.05}) {
      const dvec3 wo = direction(cos_o, 0.3);
      for (int b = 0; b < 2; ++b) {
        INFO(n << ' ' << cos_o << ' ' << b);
        const CoatedGround smooth{plastic.ground, {}, nullptr};
        CHECK(furnace(smooth, optics, wo, b) + coat_reflectance(optics, cos_o, b) ==
              Approx(1.0).margin(0.005));
      }
    }
  }
  for (const double roughness : {0.05, 0.3, 0.6, 1.0}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const DielectricAlbedo albedo(ggx, 2.5);
    for (const double n : {1.33, 1.5, 2.4}) {
      const Plastic plastic(n, 1.0f, 1.0f);
      for (const double cos_o : {1.0, 0.6, 0.2, 0.05}) {
        INFO(roughness << ' ' << n << ' ' << cos_o);
        const CoatedGround rough{plastic.ground, ggx, &albedo};
        CHECK(furnace(rough, plastic.optics(), direction(cos_o, 0.3), 0) ==
              Approx(1.0).margin(0.005));
      }
    }
  }
}

TEST_CASE("light between ground and coat is the sum over its passes") {
  const Plastic plastic(1.5, 0.6f, 0.3f);
  const SurfaceOptics optics = plastic.optics();
  const CoatedGround smooth{plastic.ground, {}, nullptr};
  const dvec3 wo = direction(0.7, 0.0), wi = direction(0.4, 2.0);
  for (int b = 0; b < 2; ++b) {
    const double eta = plastic.coat[b], rho = static_cast<double>(plastic.ground[b]);
    const double within = 1.0 - diffuse_transmittance(1.0 / eta);
    double passes = 0.0, part = rho;
    for (int i = 0; i < 60; ++i, part *= rho * within)
      passes += part;
    const double expected = (1.0 - fresnel_reflectance(0.7, eta)) *
                            (1.0 - fresnel_reflectance(0.4, eta)) * passes * 0.4 /
                            (std::numbers::pi * eta * eta);
    CHECK(evaluate(smooth, optics, wo, wi).f[b] == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("coated surfaces are reciprocal and return nothing from below") {
  const Plastic plastic(1.5, 0.9f, 0.4f);
  const SurfaceOptics optics = plastic.optics();
  const Ggx ggx = Ggx::from_roughness(0.6);
  const DielectricAlbedo albedo(ggx, 2.0);
  const dvec3 wo = direction(0.8, 0.0), wi = direction(0.15, 2.0);
  for (const CoatedGround& surface :
       {CoatedGround{plastic.ground, {}, nullptr}, CoatedGround{plastic.ground, ggx, &albedo}}) {
    for (int b = 0; b < 2; ++b)
      CHECK(evaluate(surface, optics, wo, wi).f[b] / wi.z ==
            Approx(evaluate(surface, optics, wi, wo).f[b] / wo.z).epsilon(1e-6));
    CHECK(evaluate(surface, optics, wo, -wi).pdf == 0.0);
    CHECK(evaluate(surface, optics, wo, -wi).f[0] == 0.0);
  }
}

TEST_CASE("coated surfaces are sampled with the pdf that they return") {
  const Plastic plastic(1.5, 0.9f, 0.1f);
  const SurfaceOptics optics = plastic.optics();
  for (const double roughness : {0.5, 0.8}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const DielectricAlbedo albedo(ggx, 2.0);
    const CoatedGround surface{plastic.ground, ggx, &albedo};
    for (const double cos_o : {0.9, 0.2}) {
      const dvec3 wo = direction(cos_o, 0.5);
      CHECK(test::deviation_from_density(
                [&](const dvec2& u, double choice) {
                  const int b = choice < 0.5 ? 0 : 1;
                  return sample_coated_ground(surface, optics, wo, b, u, 2.0 * choice - b);
                },
                [&](const dvec3& wi) { return evaluate(surface, optics, wo, wi).pdf; }) < 4.0);
    }
  }
}
