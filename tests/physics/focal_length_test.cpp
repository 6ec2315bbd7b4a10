#include "io/selftest/expected_index.h"
#include "io/selftest/single_ray.h"
#include "tests/catch.h"

#include <cmath>

using namespace abbe;

namespace {

/// A biconvex lens with |R| = 100 and centre thickness 10 about the origin, axis along z: the
/// intersection of two balls whose near surfaces pass z = -5 and z = +5.
CsgTree biconvex() {
  const auto ball = [](double z) {
    return CsgTree(Sphere{},
                   Transform::translation({0, 0, z}).after(Transform::scaling(dvec3(100))));
  };
  return {CsgOperation::intersect, ball(95.0), ball(-95.0)};
}

double effective_focal_length(const World& world, double n) {
  const double height = 1e-3; // paraxial: the error of this height is of order (h/R)^2 = 1e-10
  const Ray out = refracted_through(world, {{0.0, height, -50.0}, {0.0, 0.0, 1.0}}, n).ray;
  return -height / (out.direction.y / out.direction.z);
}

} // namespace

// The lensmaker's equation for a thick lens, 1/f = (n-1) (1/R1 - 1/R2 + (n-1) t / (n R1 R2)), with
// n of N-BK7 gives these three figures (computed outside this project from Schott's coefficients).
TEST_CASE("a biconvex N-BK7 lens focuses F, d and C at their published lengths") {
  const World world({{biconvex(), Transform(), MaterialId{0}, MediumId{0}, 0}}, 50.0);
  const auto at = [&](double nm) {
    return effective_focal_length(world, catalogue_index("N-BK7", nm));
  };
  CHECK(at(486.1327) == Approx(97.387278).margin(1e-3));
  CHECK(at(587.5618) == Approx(98.425992).margin(1e-3));
  CHECK(at(656.2725) == Approx(98.894721).margin(1e-3));
}

TEST_CASE("the lens's focal length agrees with the lensmaker's equation for any index") {
  const World world({{biconvex(), Transform(), MaterialId{0}, MediumId{0}, 0}}, 50.0);
  for (double n = 1.2; n < 2.5; n += 0.1) {
    const double power = (n - 1.0) * (0.02 - (n - 1.0) * 10.0 / (n * 100.0 * 100.0));
    CHECK(effective_focal_length(world, n) == Approx(1.0 / power).epsilon(1e-7));
  }
}
