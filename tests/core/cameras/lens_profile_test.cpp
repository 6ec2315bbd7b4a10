#include "core/cameras/lens_profile.h"

#include "core/cameras/lens_system.h"
#include "tests/catch.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <stdexcept>

using namespace abbe;

TEST_CASE("rays meet a paraboloid where the quadratic equation says") {
  // z = c (x^2 + y^2) / 2, and (x, y, z) = q + t d.
  const double c = 0.13;
  const LensProfile paraboloid{c, -1.0, {}};
  for (const double x : {0.0, 0.4, -2.5})
    for (const dvec3 towards : {dvec3(0.0, 0.0, 1.0), dvec3(0.3, -0.2, 1.0), dvec3(0.1, 0.5, -1)}) {
      const dvec3 q{x, 0.7, 0.0}, d = glm::normalize(towards);
      const double a = 0.5 * c * (d.x * d.x + d.y * d.y);
      const double half_b = 0.5 * (c * (q.x * d.x + q.y * d.y) - d.z);
      const double f = 0.5 * c * (q.x * q.x + q.y * q.y);
      const double root = std::sqrt(half_b * half_b - a * f);
      const double expected = half_b < 0.0 ? f / (-half_b + root) : f / (-half_b - root);
      CHECK(meet_profile(paraboloid, 4.0, q, d) == Approx(expected).epsilon(1e-15));
    }
}

TEST_CASE("a polynomial is met as closely as its sag is computed") {
  const LensProfile profile{1.0 / 15.5, -0.7, {0.0, 1.1e-5, -2e-9}};
  for (int i = 0; i < 200; ++i) {
    const double x = -11.0 + 0.11 * i;
    const dvec3 q{x, 0.3, 0.0}, d = glm::normalize(dvec3(-0.01 * i + 1.0, 0.2, 3.0));
    const double t = meet_profile(profile, 12.0, q, d);
    const dvec3 p = q + t * d;
    const double height = std::hypot(p.x, p.y);
    if (height < 12.0) CHECK(std::abs(p.z - profile.sag(height)) < 4e-15 * 12.0);
  }
}

TEST_CASE("a profile that bends back and forth is met once, inside its bracket") {
  const LensProfile wavy{0.0, 0.0, {0.5, -0.3, 0.04}};
  const double t = meet_profile(wavy, 2.0, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  CHECK(t == Approx(0.5 - 0.3 + 0.04).epsilon(1e-15));
}

TEST_CASE("a hyperbolic lens has no spherical aberration") {
  // Parallel light in glass of index n leaves by a hyperboloid of conic constant -n^2; all of it
  // meets at |R| / (n - 1) behind the vertex [BW99, 4.2.1: the stigmatic surface for one point at
  // infinity].
  const double n = 1.5, r = -20.0, height = 15.0;
  LensPrescription lens;
  lens.surfaces = {{0.0, 10.0, ConstantIndex{n}, height, 0.0, {}},
                   {r, 0.0, ConstantIndex{1.0}, height, -n * n, {}}};
  const LensSystem system(lens);
  const double focus = system.last_vertex() - r / (n - 1.0);
  for (const double y : {0.1, 3.0, 9.0, 14.9}) {
    const auto ray =
        system.trace_from_object({{0.0, y, -1.0}, {0.0, 0.0, 1.0}}, system.indices(550));
    REQUIRE(ray);
    const dvec3 o = ray->ray.origin, d = ray->ray.direction;
    CHECK(o.z - o.y / d.y * d.z == Approx(focus).epsilon(1e-13));
    // Backwards the ray takes the same way.
    const auto back = system.trace_from_film({o + 5.0 * d, -d}, system.indices(550));
    REQUIRE(back);
    CHECK(back->ray.direction.z == Approx(-1.0).epsilon(1e-14));
    CHECK(back->ray.origin.y == Approx(y).epsilon(1e-13));
  }
  // The paraxial focus is that of the sphere that touches the vertex.
  CHECK(system.paraxial(550).back_focal_length() == Approx(-r / (n - 1.0)).epsilon(1e-14));
}

TEST_CASE("a conic that ends before its semi-diameter, or has none, is no lens") {
  LensPrescription lens;
  lens.surfaces = {{10.0, 5.0, ConstantIndex{1.5}, 9.0, 1.0, {}},
                   {0.0, 0.0, ConstantIndex{1.0}, 9.0, 0.0, {}}};
  CHECK_THROWS_AS(LensSystem(lens), std::invalid_argument); // it ends at 10 / sqrt(2)
  lens.surfaces[0].semi_diameter_mm = 7.0;
  CHECK_NOTHROW(LensSystem(lens));
  lens.surfaces[0].semi_diameter_mm.reset();
  CHECK_THROWS_AS(LensSystem(lens), std::invalid_argument);
}
