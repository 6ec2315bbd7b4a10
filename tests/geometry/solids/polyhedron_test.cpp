#include "geometry/solids/polyhedron.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <algorithm>
#include <numbers>

using namespace abbe;
using reference::Random;

namespace {

/// The half-space whose plane the x axis crosses at `t` with a normal of slope `tilt`.
HalfSpace cut(double t, double tilt) {
  const dvec3 n = glm::normalize(dvec3(tilt, 1.0, -0.5));
  return {n, n.x * t};
}

std::optional<Interval> line(const dvec3& origin, const dvec3& direction) {
  return intersect(thesis_prism(), LocalRay{origin, direction});
}

} // namespace

TEST_CASE("the interval of the thesis's figure 12") {
  // Its ray enters plane one at 1.5, leaves plane two at 2.9 and plane three at 2.3.
  std::vector<HalfSpace> planes{{{-1, 0, 0}, 50.0}, cut(1.5, -2.0), cut(2.9, 0.5), cut(2.3, 3.0)};
  for (const dvec3& n : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1)})
    planes.push_back({n, 50.0});
  planes.push_back({{0, 0, -1}, 50.0});
  const LocalRay ray{{0, 0, 0}, {1, 0, 0}};
  const auto found = intersect(ConvexPolyhedron(planes), ray);
  REQUIRE(found);
  REQUIRE(found->enter.t == Approx(1.5).epsilon(1e-15));
  REQUIRE(found->exit.t == Approx(2.3).epsilon(1e-15));
  REQUIRE(found->enter.face.face == 1);
  REQUIRE(found->exit.face.face == 3);
  planes.push_back(cut(1.4, 1.0)); // nothing is left of the line
  REQUIRE_FALSE(intersect(ConvexPolyhedron(planes), ray));
}

TEST_CASE("a line parallel to a plane is wholly inside or outside") {
  const auto along = [](double z) { return line({-5, 0, z}, {1, 0, 0}); };
  REQUIRE(along(0.5));
  REQUIRE(along(1.0)); // in the plane: it touches
  REQUIRE_FALSE(along(1.5));
}

namespace {

/// The interval by one half-space after the other, and its faces: of those at one place the first.
struct InTurn {
  double enter = -kInfinity, exit = kInfinity;
  int enter_face = 0, exit_face = 0;
  bool empty = false;

  InTurn(const ConvexPolyhedron& solid, const LocalRay& ray, const FaceContact* contact) {
    for (int i = 0; i < static_cast<int>(solid.half_spaces().size()); ++i) {
      if (contact && contact->face == i) continue;
      const HalfSpace& h = solid.half_spaces()[static_cast<std::size_t>(i)];
      const double along = glm::dot(h.normal, ray.direction);
      const double height = h.offset - glm::dot(h.normal, ray.origin);
      if (along == 0.0) {
        empty |= !contact && height < 0.0;
      } else if (along > 0.0 && height / along < exit) {
        exit = height / along;
        exit_face = i;
      } else if (along < 0.0 && !contact && height / along > enter) {
        enter = height / along;
        enter_face = i;
      }
    }
    if (contact) {
      enter = 0.0;
      enter_face = contact->face;
    } else {
      empty |= enter > exit;
    }
  }
};

} // namespace

TEST_CASE("half-spaces four at a time cut lines as they do one after the other") {
  Random random(18);
  int met = 0;
  for (int k = 0; k < 3000; ++k) {
    static std::optional<ConvexPolyhedron> solid;
    if (k % 20 == 0) solid = ConvexPolyhedron(random.planes(4 + random.below(12)));
    if (k % 60 == 40) // lines through edges and corners of a cube meet planes at one place
      solid = ConvexPolyhedron({{{1, 0, 0}, 1},
                                {{-1, 0, 0}, 1},
                                {{0, 1, 0}, 1},
                                {{0, -1, 0}, 1},
                                {{0, 0, 1}, 1},
                                {{0, 0, -1}, 1}});
    const bool grid = k % 60 >= 40;
    const auto some = [&] {
      return grid ? dvec3(random.below(5) - 2, random.below(5) - 2, random.below(5) - 2)
                  : random.in_cube(2.0);
    };
    const dvec3 direction = some();
    if (direction == dvec3(0.0)) continue;
    const LocalRay ray{some(), direction};
    const FaceContact touched{random.below(static_cast<int>(solid->half_spaces().size())),
                              Side::inside};
    for (const FaceContact* contact : {static_cast<const FaceContact*>(nullptr), &touched}) {
      const auto found = plane_interval(*solid, ray, contact);
      const InTurn expected(*solid, ray, contact);
      REQUIRE(found.has_value() == !expected.empty);
      if (!found) continue;
      ++met;
      REQUIRE(found->enter.t == expected.enter);
      REQUIRE(found->exit.t == expected.exit);
      REQUIRE(found->enter.face == expected.enter_face);
      REQUIRE(found->exit.face == expected.exit_face);
    }
  }
  CHECK(met > 3000);
}

TEST_CASE("the thesis's prism has the vertices of its table 1") {
  const double s = std::numbers::sqrt3;
  const auto vertices = thesis_prism().vertices();
  REQUIRE(vertices.size() == 6);
  for (const double y : {-1.0, 1.0})
    for (const dvec3 expected : {dvec3(0, y, -2), dvec3(s, y, 1), dvec3(-s, y, 1)})
      CHECK(std::count_if(vertices.begin(), vertices.end(),
                          [&](const dvec3& v) { return glm::length(v - expected) < 1e-14; }) == 1);
}

TEST_CASE("prism: closed forms") {
  const double s = std::numbers::sqrt3;
  // Along z through the apex: from the edge at -2 to the face z = 1.
  const auto z = line({0, 0, -5}, {0, 0, 1});
  REQUIRE(z);
  REQUIRE(z->enter.t == Approx(3.0));
  REQUIRE(z->exit.t == Approx(6.0));
  REQUIRE(z->exit.face.face == 2);
  // Along x at z = 0 the triangle is 2 (2 / sqrt 3) wide, at z = 1 - 2e-16.. its whole base.
  const auto x = line({-5, 0, 0}, {1, 0, 0});
  REQUIRE(x);
  REQUIRE(x->enter.t == Approx(5 - 2 / s));
  REQUIRE(x->exit.t == Approx(5 + 2 / s));
  REQUIRE(x->enter.face.face == 3);
  REQUIRE(x->exit.face.face == 4);
  // In the plane of the base, just over it, along the apex edge, and beside that edge.
  const auto base = line({-5, 0, 1}, {1, 0, 0});
  REQUIRE(base);
  REQUIRE(base->exit.t - base->enter.t == Approx(2 * s));
  REQUIRE_FALSE(line({-5, 0, 1 + 1e-15}, {1, 0, 0}));
  REQUIRE_FALSE(line({0, -5, -2 - 1e-15}, {0, 1, 0}));
  const auto along_y = line({0, -5, 0}, {0, 2, 0});
  REQUIRE(along_y);
  REQUIRE(along_y->enter.t == 2.0);
  REQUIRE(along_y->exit.t == 3.0);
}

TEST_CASE("polyhedron: with a contact") {
  const FaceContact in{2, Side::inside}, out{2, Side::outside};
  const auto through = intersect(thesis_prism(), LocalRay{{0, 0, 1}, {0, 0, -1}}, &in);
  REQUIRE(through);
  REQUIRE(through->enter.t == 0.0);
  REQUIRE(through->exit.t == Approx(3.0));
  REQUIRE_FALSE(intersect(thesis_prism(), LocalRay{{0, 0, 1}, {0, 0, 1}}, &out));
  REQUIRE(intersect(thesis_prism(), LocalRay{{0, 0, 1}, {0, 1, 1e-17}}, &in)->exit.face.face == 0);
}

TEST_CASE("polyhedron: t_error bounds the error of both roots") {
  Random random(8);
  double worst = 0.0;
  for (int k = 0; k < 50000; ++k) {
    static reference::Twin twin = reference::polyhedron(random.planes(9));
    if (k % 100 == 0) twin = reference::polyhedron(random.planes(9));
    const dvec3 o = random.direction() * std::exp(random.uniform(-2.0, 14.0));
    const dvec3 d = (random.in_cube(1.0) - o) * std::exp(random.uniform(-5, 5));
    const auto ours = intersect(std::get<ConvexPolyhedron>(twin.placed.shape), LocalRay{o, d});
    const auto truth = twin.solid.crossings(reference::Vec(o), reference::Vec(d));
    if (truth.size() != 2 || !ours) continue;
    worst = std::max(worst, std::abs(double(ours->enter.t - truth[0].t)) / ours->enter.t_error);
    worst = std::max(worst, std::abs(double(ours->exit.t - truth[1].t)) / ours->exit.t_error);
  }
  CHECK(worst < 1.0);
}

TEST_CASE("polyhedron: t_error holds along a tilted needle, whose near planes are met far away") {
  Random random(14);
  double worst = 0.0;
  for (int k = 0; k < 300; ++k) {
    const glm::dmat3 turn = random.rotation();
    std::vector<HalfSpace> planes;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0})
        planes.push_back({sign * turn[axis], axis == 2 ? 1e4 : 1.0});
    const reference::Twin twin = reference::polyhedron(planes);
    for (int i = 0; i < 100; ++i) {
      const dvec3 to(random.chance(0.5) ? 1 : -1, 0, random.uniform(-1e4, 1e4));
      const dvec3 o = random.in_cube(0.5), d = glm::normalize(turn * to - o);
      const auto ours = intersect(std::get<ConvexPolyhedron>(twin.placed.shape), LocalRay{o, d});
      const auto truth = twin.solid.crossings(reference::Vec(o), reference::Vec(d));
      REQUIRE(ours);
      REQUIRE(truth.size() == 2);
      worst = std::max(worst, std::abs(double(ours->exit.t - truth[1].t)) / ours->exit.t_error);
    }
  }
  CHECK(worst < 1.0);
}

TEST_CASE("polyhedron: solids that are none are refused") {
  const HalfSpace up{{0, 0, 1}, 1}, down{{0, 0, -1}, 1};
  const HalfSpace right{{1, 0, 0}, 1}, left{{-1, 0, 0}, 1};
  const HalfSpace front{{0, 1, 0}, 1}, back{{0, -1, 0}, 1};
  using Planes = std::vector<HalfSpace>;
  REQUIRE_NOTHROW(ConvexPolyhedron(Planes{up, down, right, left, front, back}));
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{}), std::invalid_argument);
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{up, down, right, left, front}), std::invalid_argument);
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{up, down, right, left}), std::invalid_argument);
  // A pyramid without a base is open downwards though three of its planes meet in a point.
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{{{1, 0, 1}, 1}, {{-1, 0, 1}, 1}, {{0, 1, 1}, 1}}),
                    std::invalid_argument);
  // Empty, and flat.
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{{{0, 0, 1}, -2}, down, right, left, front, back}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{{{0, 0, 1}, -1}, down, right, left, front, back}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(ConvexPolyhedron(Planes{{{0, 0, 0}, 1}, down, right, left, front, back}),
                    std::invalid_argument);
}

TEST_CASE("polyhedron: size does not matter") {
  for (const double size : {1e-12, 1e-4, 1e9}) {
    std::vector<HalfSpace> planes = thesis_prism().half_spaces();
    for (HalfSpace& h : planes)
      h.offset *= size;
    const ConvexPolyhedron prism(planes);
    REQUIRE(prism.vertices().size() == 6);
    const Bounds box = bounds(prism, Transform());
    CHECK(box.lower.z == Approx(-2 * size).epsilon(1e-13).margin(0));
    CHECK(box.upper.x == Approx(std::numbers::sqrt3 * size).epsilon(1e-13).margin(0));
  }
}
