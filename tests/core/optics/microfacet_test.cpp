#include "core/optics/microfacet.h"

#include "core/optics/albedo_table.h"
#include "core/optics/microfacet_albedo.h"
#include "tests/catch.h"
#include "tests/core/scattering/directions.h"

#include <glm/geometric.hpp>

using namespace abbe;
using test::direction;
using test::sphere_integral;

TEST_CASE("the facets' projected area is that of the surface") {
  for (const double alpha : {0.1, 0.3, 1.0})
    CHECK(sphere_integral([&](const dvec3& h) { return Ggx{alpha}.density(h) * h.z; }, 0.0, 1.0,
                          2000) == Approx(1.0).epsilon(1e-3));
  CHECK(Ggx::from_roughness(0.3).alpha == Approx(0.09));
}

TEST_CASE("GGX agrees with its formula in cosines") { // alpha^2 / (pi cos^4 (alpha^2 + tan^2)^2)
                                                      // [Walter07, 33]
  for (const double alpha : {0.05, 0.4, 1.0})
    for (const double cosine : {1.0, 0.99, 0.7, 0.2}) {
      const double cos2 = cosine * cosine, tan2 = (1.0 - cos2) / cos2;
      CHECK(Ggx{alpha}.density(direction(cosine, 1.0)) ==
            Approx(alpha * alpha /
                   (std::numbers::pi * cos2 * cos2 * std::pow(alpha * alpha + tan2, 2)))
                .epsilon(1e-9));
      CHECK(Ggx{alpha}.g1(direction(cosine, 1.0)) ==
            Approx(2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * tan2))).epsilon(1e-12));
    }
}

TEST_CASE("masking makes the visible facets fill the view") {
  // The integral of D G1 max(0, wo . h) is wo.z [Heitz14], so the visible normals have a pdf.
  for (const double alpha : {0.3, 0.6, 1.0})
    for (const double cosine : {1.0, 0.6, 0.2}) {
      const dvec3 wo = direction(cosine, 0.4);
      CHECK(sphere_integral([&](const dvec3& h) { return Ggx{alpha}.visible_pdf(wo, h); }, 0.0, 1.0,
                            1000) == Approx(1.0).epsilon(2e-3));
    }
}

TEST_CASE("normals are sampled with the pdf of the visible ones") {
  for (const double alpha : {0.3, 0.6, 1.0})
    for (const double cosine : {1.0, 0.6, 0.1}) {
      INFO(alpha << ' ' << cosine);
      const Ggx ggx{alpha};
      const dvec3 wo = direction(cosine, 2.0);
      CHECK(test::deviation_from_density(
                [&](const dvec2& u, double) {
                  return std::optional(ggx.sample_visible_normal(wo, u));
                },
                [&](const dvec3& h) { return h.z > 0.0 ? ggx.visible_pdf(wo, h) : 0.0; }) < 4.0);
    }
}

TEST_CASE("joint masking lies between its bounds") {
  const Ggx ggx{0.5};
  for (const double o : {0.05, 0.4, 1.0})
    for (const double i : {0.05, 0.4, 1.0}) {
      const dvec3 wo = direction(o, 0.0), above = direction(i, 1.0), below = direction(-i, 1.0);
      const double apart = ggx.g1(wo) * ggx.g1(above);
      // On one side a high facet is visible from both directions, on opposite sides only from one.
      CHECK(ggx.g2(wo, above) <= std::min(ggx.g1(wo), ggx.g1(above)) * (1.0 + 1e-12));
      CHECK(ggx.g2(wo, above) >= apart * (1.0 - 1e-12));
      CHECK(ggx.g2(wo, below) <= apart * (1.0 + 1e-12));
      CHECK(ggx.g2(wo, below) == Approx(ggx.g2(above, -wo)));
      // The integral over heights u of u^Lambda_o (1 - u)^Lambda_i.
      double sum = 0.0;
      for (int n = 0; n < 20000; ++n) {
        const double u = (n + 0.5) / 20000;
        sum += std::pow(u, ggx.lambda(wo)) * std::pow(1.0 - u, ggx.lambda(below)) / 20000;
      }
      CHECK(ggx.g2(wo, below) == Approx(sum).epsilon(1e-4));
    }
  CHECK(ggx.g2(direction(0.5, 0.0), direction(0.0, 1.0)) == 0.0);
}

TEST_CASE("the albedo of one reflection agrees with a sum over directions") {
  for (const double alpha : {0.3, 1.0})
    for (const double mu : {0.15, 0.5, 0.95}) {
      const Ggx ggx{alpha};
      const dvec3 wo = direction(mu, 0.0);
      const double expected = sphere_integral(
          [&](const dvec3& wi) {
            const dvec3 h = glm::normalize(wo + wi);
            return ggx.density(h) * ggx.g2(wo, wi) / (4.0 * mu);
          },
          0.0, 1.0, 800);
      CHECK(reflected_once(ggx, mu) == Approx(expected).margin(2e-3));
      CHECK(GgxAlbedo(ggx).at(mu) == Approx(expected).margin(3e-3));
    }
}

TEST_CASE("tables return the functions that they were made from") {
  const CosineTable line([](double mu) { return 2.0 + std::sqrt(mu); });
  CHECK(line.at(CosineTable::place(0.3)) == Approx(2.0 + std::sqrt(0.3)).epsilon(1e-12));
  CHECK(line.at(CosineTable::place(1.0)) == Approx(3.0).epsilon(1e-12));
  // 2 (2 + sqrt(mu)) mu from 0 to 1 is 2 + 4/5; below the first knot it is constant.
  CHECK(line.mean() == Approx(2.8).epsilon(1e-6));
  const Ggx ggx{0.49};
  const DielectricAlbedo albedo(ggx, 2.5);
  for (const double eta : {1.0 / 2.4, 1.0 / 1.5, 0.75, 1.05, 1.33, 1.5, 2.4})
    for (const double mu : {0.03, 0.2, 0.6, 0.97}) {
      INFO(eta << ' ' << mu);
      const OnceScattered once = scattered_once(ggx, mu, eta);
      const EtaPlace place = albedo.place(eta);
      CHECK(albedo.reflected(place, CosineTable::place(mu)) == Approx(once.reflected).margin(4e-3));
      CHECK(albedo.scattered(place, CosineTable::place(mu)) ==
            Approx(once.reflected + once.transmitted).margin(4e-3));
      const EtaPlace there = albedo.place(1.0 / eta), back = DielectricAlbedo::reversed(place);
      CHECK(albedo.mean_scattered(there) == Approx(albedo.mean_scattered(back)).epsilon(1e-9));
      CHECK(back.eta == Approx(1.0 / eta));
    }
}
