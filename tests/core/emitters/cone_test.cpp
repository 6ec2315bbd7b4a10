#include "core/emitters/cone.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace abbe;

TEST_CASE("a cone to a ball touches it") {
  // Seen from 5 away a ball of radius 3 fills the cone with sine 0.6, cosine 0.8.
  const Cone cone = cone_to_ball({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, 3.0);
  CHECK(cone.axis.z == Approx(-1.0));
  CHECK(cone.one_minus_cos == Approx(0.2).epsilon(1e-14));
  CHECK(cone.solid_angle() == Approx(0.4 * std::numbers::pi).epsilon(1e-14));
  CHECK(cone_to_ball({0.0, 0.0, 2.0}, dvec3(0.0), 3.0).solid_angle() ==
        Approx(4.0 * std::numbers::pi));
}

TEST_CASE("a narrow cone keeps its digits") {
  // sin^2 / 2 to first order, where 1 - cos would have none left.
  const Cone cone = cone_to_ball({1e9, 0.0, 0.0}, dvec3(0.0), 1.0);
  CHECK(cone.one_minus_cos == Approx(0.5e-18).epsilon(1e-12));
}

TEST_CASE("directions fill a cone evenly") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  const Cone cone{glm::normalize(dvec3(0.3, -0.5, 0.2)), 0.4};
  const Cone half{cone.axis, 0.2};
  const Cone away{-cone.axis, 0.4};
  int inner = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const dvec3 d = cone.sample({unit(random), unit(random)});
    REQUIRE(glm::length(d) == Approx(1.0).epsilon(1e-14));
    REQUIRE(glm::dot(d, cone.axis) >= 0.6 - 1e-12);
    REQUIRE_FALSE(away.holds(d));
    inner += half.holds(d) ? 1 : 0;
  }
  // Half the solid angle gets half of them; five standard deviations.
  CHECK(std::abs(inner - kCount / 2) < 5.0 * std::sqrt(kCount / 4.0));
}
