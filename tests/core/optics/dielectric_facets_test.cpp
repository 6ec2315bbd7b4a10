#include "core/optics/dielectric_facets.h"

#include "core/optics/fresnel.h"
#include "tests/catch.h"
#include "tests/core/scattering/directions.h"

#include <glm/geometric.hpp>

using namespace abbe;
using test::direction;

namespace {

constexpr int kBands = 3;

/// A boundary at three bands.
struct Glass {
  double before[kBands], after[kBands];
  Glass(double n_before, double n_after, double step = 0.0) {
    for (int b = 0; b < kBands; ++b) {
      before[b] = n_before > n_after ? n_before + step * b : n_before;
      after[b] = n_before > n_after ? n_after : n_after + step * b;
    }
  }
  [[nodiscard]] SurfaceOptics optics() const {
    SurfaceOptics o;
    o.n_before = before;
    o.n_after = after;
    return o;
  }
};

struct Scatter {
  double f[kBands], pdf;
};

Scatter evaluate(DielectricFacets surface, const SurfaceOptics& optics, const dvec3& wo,
                 const dvec3& wi, Transport transport = Transport::radiance,
                 BandSet bands = {0, kBands}) {
  float f[kBands] = {};
  Scatter s{};
  surface.transport = transport;
  s.pdf = evaluate_dielectric_facets(surface, optics, wo, wi, bands, f);
  std::copy(f, f + kBands, s.f);
  return s;
}

/// Samples with a band that the number for the lobe also chooses.
std::optional<dvec3> sample(const DielectricFacets& surface, const SurfaceOptics& optics,
                            const dvec3& wo, const dvec2& u, double choice) {
  const int band = static_cast<int>(choice * kBands);
  return sample_dielectric_facets(surface, optics, wo, band, u, choice * kBands - band);
}

/// The reflected and the transmitted flux of band 0. Radiance counts with the n^2 of the side that
/// it comes from, as in a furnace of uniform temperature.
double furnace(const DielectricFacets& surface, const SurfaceOptics& optics, double cos_o,
               Transport transport, int count = 16000) {
  const dvec3 wo = direction(cos_o, 0.3);
  const double eta = optics.n_after[0] / optics.n_before[0];
  return test::sampled_albedo(
      count, [&](const dvec2& u, double choice) { return sample(surface, optics, wo, u, choice); },
      [&](const dvec3& wi) {
        const Scatter s = evaluate(surface, optics, wo, wi, transport);
        const bool n2 = wi.z < 0.0 && transport == Transport::radiance;
        return s.f[0] / s.pdf * (n2 ? eta * eta : 1.0);
      });
}

} // namespace

TEST_CASE("rough clear glass with compensation loses no light") {
  for (const double roughness : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const DielectricAlbedo albedo(ggx, 2.5);
    for (const double n : {1.33, 1.5, 2.4})
      for (const bool from_inside : {false, true}) {
        const Glass glass(from_inside ? n : 1.0, from_inside ? 1.0 : n);
        for (const double cos_o : {1.0, 0.8, 0.5, 0.2, 0.05}) {
          INFO(roughness << ' ' << n << (from_inside ? " inside " : " outside ") << cos_o);
          const SurfaceOptics optics = glass.optics();
          CHECK(furnace({ggx, &albedo}, optics, cos_o, Transport::radiance) ==
                Approx(1.0).margin(0.005));
          CHECK(furnace({ggx}, optics, cos_o, Transport::flux) <= 1.001);
        }
      }
  }
}

TEST_CASE("compensated glass conserves energy in a sum over directions") {
  const Ggx ggx = Ggx::from_roughness(0.8);
  const DielectricAlbedo albedo(ggx, 2.0);
  for (const bool from_inside : {false, true}) {
    const Glass glass(from_inside ? 1.5 : 1.0, from_inside ? 1.0 : 1.5);
    for (const double cos_o : {0.95, 0.4}) {
      const dvec3 wo = direction(cos_o, 0.0);
      const DielectricFacets surface{ggx, &albedo};
      const SurfaceOptics optics = glass.optics();
      CHECK(test::sphere_integral(
                [&](const dvec3& wi) {
                  return evaluate(surface, optics, wo, wi, Transport::flux).f[0];
                },
                -1.0, 1.0, 800) == Approx(1.0).margin(0.005));
    }
  }
}

TEST_CASE("rough glass is reciprocal with the squares of the indices") {
  const Ggx ggx = Ggx::from_roughness(0.7);
  const DielectricAlbedo albedo(ggx, 2.0);
  const auto flipped = [](const dvec3& w) { return dvec3{w.x, w.y, -w.z}; };
  int seen = 0;
  for (const DielectricAlbedo* compensation :
       {static_cast<const DielectricAlbedo*>(nullptr), &albedo})
    for (const double n_o : {1.0, 1.33, 1.6})
      for (const double n_i : {1.0, 1.5})
        for (const double o : {0.97, 0.5, 0.1})
          for (const double i : {0.9, 0.3, -0.2, -0.6, -0.98}) {
            INFO(n_o << ' ' << n_i << ' ' << o << ' ' << i << ' ' << (compensation != nullptr));
            const dvec3 wo = direction(o, 0.2), wi = direction(i, 3.0);
            const DielectricFacets surface{ggx, compensation};
            const Glass there(n_o, n_i), back(n_i, n_o);
            if (n_o == n_i) continue;
            if (i > 0.0) {
              CHECK(evaluate(surface, there.optics(), wo, wi).f[0] / i ==
                    Approx(evaluate(surface, there.optics(), wi, wo).f[0] / o).epsilon(1e-6));
              continue;
            }
            for (const Transport t : {Transport::radiance, Transport::flux}) {
              const double n2 =
                  t == Transport::radiance ? n_o * n_o / (n_i * n_i) : n_i * n_i / (n_o * n_o);
              const double f = evaluate(surface, there.optics(), wo, wi, t).f[0] / -i;
              CHECK(f ==
                    Approx(n2 * evaluate(surface, back.optics(), flipped(wi), flipped(wo), t).f[0] /
                           o)
                        .epsilon(1e-6)
                        .margin(1e-12));
              seen += f > 0.0;
            }
          }
  CHECK(seen > 100);
}

TEST_CASE("rough glass is the formula of its facets") {
  // |i.h o.h| / (cos_i cos_o) n_i^2 (1 - F) D G2 / (n_o o.h + n_i i.h)^2 for flux [Walter07, 21].
  const double alpha = 0.3, n = 1.5;
  const auto tan2 = [](const dvec3& w) { return (1.0 - w.z * w.z) / (w.z * w.z); };
  const Glass glass(1.0, n);
  const DielectricFacets surface{Ggx{alpha}};
  for (const double cos_o : {0.95, 0.5})
    for (const double cos_i : {-0.98, -0.95, -0.85, -0.6}) {
      const dvec3 wo = direction(cos_o, 0.0), wi = direction(cos_i, 2.9);
      const dvec3 h = glm::normalize(-(wo + n * wi));
      const double o = glm::dot(wo, h), i = glm::dot(wi, h);
      const double d = alpha * alpha /
                       (std::numbers::pi * std::pow(h.z, 4) * std::pow(alpha * alpha + tan2(h), 2));
      const double g = Ggx{alpha}.g2(wo, wi);
      const double expected = o * -i * n * n * (1.0 - fresnel_reflectance(o, n)) * d * g /
                              (std::pow(o + n * i, 2) * cos_o);
      if (!(o > 0.0 && i < 0.0 && h.z > 0.0)) { // no facet sends light there
        CHECK(evaluate(surface, glass.optics(), wo, wi).f[0] == 0.0);
        continue;
      }
      CHECK(evaluate(surface, glass.optics(), wo, wi, Transport::flux).f[0] ==
            Approx(expected).epsilon(1e-6));
      CHECK(evaluate(surface, glass.optics(), wo, wi, Transport::radiance).f[0] ==
            Approx(expected / (n * n)).epsilon(1e-6));
    }
}

TEST_CASE("rough glass, dispersive or not, is sampled with the pdf that it returns") {
  for (const double roughness : {0.5, 0.75, 1.0}) {
    const Ggx ggx = Ggx::from_roughness(roughness);
    const DielectricAlbedo albedo(ggx, 2.5);
    for (const DielectricAlbedo* compensation :
         {static_cast<const DielectricAlbedo*>(nullptr), &albedo})
      for (const double step : {0.0, 0.3})
        for (const bool from_inside : {false, true})
          for (const double cos_o : {0.9, 0.3}) {
            INFO(roughness << ' ' << step << ' ' << from_inside << ' ' << cos_o << ' '
                           << (compensation != nullptr));
            const Glass glass(from_inside ? 1.5 : 1.0, from_inside ? 1.0 : 1.5, step);
            const SurfaceOptics optics = glass.optics();
            const DielectricFacets surface{ggx, compensation};
            const dvec3 wo = direction(cos_o, 0.5);
            CHECK(test::deviation_from_density(
                      [&](const dvec2& u, double choice) {
                        return sample(surface, optics, wo, u, choice);
                      },
                      [&](const dvec3& wi) { return evaluate(surface, optics, wo, wi).pdf; },
                      100000) < 4.0);
          }
  }
}

TEST_CASE("polished glass reflects and transmits as a smooth one") {
  const Ggx ggx = Ggx::from_roughness(0.03);
  const DielectricAlbedo albedo(ggx, 2.5);
  const Glass glass(1.0, 1.5);
  const SurfaceOptics optics = glass.optics();
  for (const DielectricAlbedo* compensation :
       {static_cast<const DielectricAlbedo*>(nullptr), &albedo})
    for (const double cos_o : {1.0, 0.6, 0.2}) {
      const dvec3 wo = direction(cos_o, 0.0);
      const DielectricFacets surface{ggx, compensation};
      double sides[2] = {0.0, 0.0};
      for (const bool above : {false, true})
        sides[above] = test::sampled_albedo(
            8000,
            [&](const dvec2& u, double choice) { return sample(surface, optics, wo, u, choice); },
            [&](const dvec3& wi) {
              const Scatter s = evaluate(surface, optics, wo, wi, Transport::flux);
              return (wi.z > 0.0) == above ? s.f[0] / s.pdf : 0.0;
            });
      CHECK(sides[1] == Approx(fresnel_reflectance(cos_o, 1.5)).margin(2e-3));
      CHECK(sides[0] == Approx(1.0 - fresnel_reflectance(cos_o, 1.5)).margin(2e-3));
    }
}

TEST_CASE("each band of a dispersive rough surface conserves energy with the shared pdf") {
  // One direction serves all bands, weighted by f_b over the mean pdf. The mean of each band must
  // be its own.
  const Ggx ggx = Ggx::from_roughness(0.6);
  const DielectricAlbedo albedo(ggx, 2.5);
  const Glass glass(1.0, 1.4, 0.2);
  const SurfaceOptics optics = glass.optics();
  const DielectricFacets surface{ggx, &albedo};
  const dvec3 wo = direction(0.7, 0.0);
  for (int b = 0; b < kBands; ++b)
    CHECK(test::sampled_albedo(
              40000,
              [&](const dvec2& u, double choice) { return sample(surface, optics, wo, u, choice); },
              [&](const dvec3& wi) {
                const Scatter s = evaluate(surface, optics, wo, wi, Transport::flux);
                return s.f[b] / s.pdf;
              }) == Approx(1.0).margin(0.005));
}

TEST_CASE("rough glass: dead bands, reflectivity and transparency, grazing light, equal media") {
  const Glass glass(1.0, 1.4, 0.2), same(1.5, 1.5);
  SurfaceOptics optics = glass.optics();
  const DielectricFacets surface{Ggx{0.4}};
  const dvec3 wo = direction(0.7, 0.0), up = direction(0.6, 2.9), down = direction(-0.9, 2.9);
  const Scatter all = evaluate(surface, optics, wo, down);
  const float live[] = {1.0f, 0.0f, 1.0f};
  const Scatter some = evaluate(surface, optics, wo, down, Transport::radiance, {0, 3, live});
  CHECK(some.f[0] == all.f[0]);
  CHECK(some.f[1] == 0.0);
  const Scatter middle = evaluate(surface, optics, wo, down, Transport::radiance, {1, 2});
  CHECK(middle.f[1] == all.f[1]);
  CHECK((2.0 * some.pdf + middle.pdf) / 3.0 == Approx(all.pdf));
  const Scatter above = evaluate(surface, optics, wo, up);
  const float reflectivity[] = {0.0f, 0.0f, 0.0f}, transparency[] = {0.5f, 0.5f, 0.5f};
  optics.reflectivity = reflectivity;
  optics.transparency = transparency;
  CHECK(evaluate(surface, optics, wo, up).f[0] == 0.0);
  CHECK(evaluate(surface, optics, wo, up).pdf == 0.0); // no sample is wasted there
  CHECK(evaluate(surface, optics, wo, down).f[0] == Approx(0.5 * all.f[0]));
  CHECK(evaluate(surface, optics, wo, down).pdf > all.pdf);
  CHECK(above.f[0] > 0.0);
  CHECK(evaluate(surface, glass.optics(), wo, dvec3{1.0, 0.0, 0.0}).pdf == 0.0);
  CHECK(evaluate(surface, same.optics(), wo, down).pdf == 0.0);
  CHECK(evaluate(surface, same.optics(), wo, -wo).pdf == 0.0);
}
