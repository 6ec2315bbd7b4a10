#include "geometry/solids/sphere.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

using namespace abbe;
using reference::Random;

namespace {

std::optional<Interval> line(const dvec3& origin, const dvec3& direction) {
  return intersect(Sphere{}, LocalRay{origin, direction});
}

} // namespace

TEST_CASE("sphere: along an axis") {
  for (int axis = 0; axis < 3; ++axis) {
    dvec3 o(0.0), d(0.0);
    o[axis] = -3.0;
    d[axis] = 2.0;
    const auto i = line(o, d);
    REQUIRE(i);
    REQUIRE(i->enter.t == 1.0);
    REQUIRE(i->exit.t == 2.0);
  }
}

TEST_CASE("sphere: from inside, from behind, past it") {
  const auto inside = line({0, 0, 0}, {0, 0, 1});
  REQUIRE(inside);
  REQUIRE(inside->enter.t == -1.0);
  REQUIRE(inside->exit.t == 1.0);
  const auto behind = line({0, 0, 3}, {0, 0, 1});
  REQUIRE(behind);
  REQUIRE(behind->exit.t == -2.0);
  REQUIRE_FALSE(line({0, 2, -3}, {0, 0, 1}));
}

TEST_CASE("sphere: tangent") {
  const auto tangent = line({1, 0, -3}, {0, 0, 1});
  REQUIRE(tangent);
  REQUIRE(tangent->enter.t == 3.0);
  REQUIRE(tangent->exit.t == 3.0);
  REQUIRE_FALSE(line({1 + 1e-15, 0, -3}, {0, 0, 1}));
  // Just inside: half a chord is sqrt(2 h - h^2) at height 1 - h.
  const double h = std::ldexp(1.0, -40);
  const auto grazing = line({1 - h, 0, -3}, {0, 0, 1});
  REQUIRE(grazing);
  REQUIRE(grazing->exit.t - 3.0 == Approx(std::sqrt(2 * h)).epsilon(1e-9));
}

TEST_CASE("sphere: on the surface, with a contact") {
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    const dvec3 p = random.direction();
    dvec3 d = random.direction();
    if (glm::dot(p, d) > 0.0) d = -d; // inwards
    const FaceContact in{0, Side::inside}, out{0, Side::outside};
    const auto through = intersect(Sphere{}, LocalRay{p, d}, &in);
    REQUIRE(through);
    REQUIRE(through->enter.t == 0.0);
    REQUIRE(through->exit.t == Approx(-2.0 * glm::dot(p, d)).margin(1e-15)); // Thales
    REQUIRE_FALSE(intersect(Sphere{}, LocalRay{p, -d}, &out));
  }
  // A direction that rounding has turned outwards still leaves at once, never at a negative t.
  const FaceContact in{0, Side::inside};
  REQUIRE(intersect(Sphere{}, LocalRay{{1, 0, 0}, {1e-17, 1, 0}}, &in)->exit.t == 0.0);
}

TEST_CASE("sphere: t_error bounds the error of both roots, near, far, grazing") {
  Random random(6);
  const reference::Solid ball = reference::sphere().solid;
  double worst = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const double far = std::exp(random.uniform(-2.0, 14.0)); // up to 1e6
    const dvec3 o = random.direction() * far;
    // Aim at a point of the disc around the centre; often close to its rim.
    const dvec3 side = glm::normalize(glm::cross(o, random.direction()));
    const double height =
        random.chance(0.5) ? random.uniform(0, 1) : 1.0 - std::exp(random.uniform(-36, 0));
    const dvec3 d = (side * height - o) * std::exp(random.uniform(-5, 5)) / far;
    const auto ours = line(o, d);
    const auto truth = ball.crossings(reference::Vec(o), reference::Vec(d));
    if (truth.size() != 2 || !ours) {
      // Only a line that touches may be decided either way: half a chord below its error.
      const double chord = truth.empty() ? double(ours ? ours->exit.t - ours->enter.t : 0.0)
                                         : double(truth[1].t - truth[0].t);
      REQUIRE(chord * glm::length(d) < 1e-7 * std::max(1.0, std::sqrt(far)));
      continue;
    }
    worst = std::max(worst, std::abs(double(ours->enter.t - truth[0].t)) / ours->enter.t_error);
    worst = std::max(worst, std::abs(double(ours->exit.t - truth[1].t)) / ours->exit.t_error);
  }
  CHECK(worst < 1.0);
}

TEST_CASE("sphere: far origins keep the accuracy of their coordinates") {
  // From (1e6, 0, 0) towards (0, 1/2, 0): the chord's half is sqrt(1 - h^2), h the line's height.
  const dvec3 o(1e6, 0, 0), d = glm::normalize(dvec3(-1e6, 0.5, 0));
  const double h = 1e6 * 0.5 / std::hypot(1e6, 0.5);
  const auto i = line(o, d);
  REQUIRE(i);
  REQUIRE(i->exit.t - i->enter.t == Approx(2 * std::sqrt(1 - h * h)).epsilon(1e-9));
}

TEST_CASE("sphere: normal, snapping, distance") {
  REQUIRE(outward_normal(Sphere{}, {0, 0, -1}, 0) == dvec3(0, 0, -1));
  REQUIRE(snapped(Sphere{}, {0, 4, 0}, 0) == dvec3(0, 1, 0));
  REQUIRE(signed_distance(Sphere{}, {0, 0, 0.5}) == -0.5);
  REQUIRE(signed_distance(Sphere{}, {0, 3, 4}) == 4.0);
}
