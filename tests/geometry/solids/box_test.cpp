#include "geometry/solids/box.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

using namespace abbe;
using reference::Random;

namespace {

std::optional<Interval> line(const dvec3& origin, const dvec3& direction) {
  return intersect(Box{}, LocalRay{origin, direction});
}

} // namespace

TEST_CASE("box: along each axis the faces are 2 axis and 2 axis + 1") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      dvec3 o(0.0), d(0.0);
      o[axis] = -sign * 3.0;
      d[axis] = sign;
      const auto i = line(o, d);
      REQUIRE(i);
      REQUIRE(i->enter.t == 2.0);
      REQUIRE(i->exit.t == 4.0);
      REQUIRE(i->enter.face.face == 2 * axis + (sign < 0 ? 1 : 0));
      REQUIRE(i->exit.face.face == 2 * axis + (sign > 0 ? 1 : 0));
      REQUIRE(outward_normal(Box{}, o, i->enter.face.face) == -d);
      REQUIRE(outward_normal(Box{}, o, i->exit.face.face) == d);
    }
}

TEST_CASE("box: parallel to a face, inside and outside its slab") {
  REQUIRE(line({0.5, -3, 0}, {0, 1, 0}));
  REQUIRE_FALSE(line({1.5, -3, 0}, {0, 1, 0}));
  REQUIRE(line({1, -3, 0}, {0, 1, 0})); // in the plane of a face: it touches
}

TEST_CASE("box: through an edge and a corner") {
  const auto corner = line({-2, -2, -2}, {1, 1, 1});
  REQUIRE(corner);
  REQUIRE(corner->enter.t == 1.0);
  REQUIRE(corner->exit.t == 3.0);
  const auto edge = line({-2, 0, 0}, {1, 1, 0}); // touches the edge x = -1, y = 1
  REQUIRE(edge);
  REQUIRE(edge->enter.t == 1.0);
  REQUIRE(edge->exit.t == 1.0);
  REQUIRE_FALSE(line({-2, 1e-15, 0}, {1, 1, 0}));
}

TEST_CASE("box: from inside and with a contact") {
  const auto inside = line({0, 0, 0.5}, {0, 0, 1});
  REQUIRE(inside);
  REQUIRE(inside->enter.t == -1.5);
  REQUIRE(inside->exit.t == 0.5);
  const FaceContact in{1, Side::inside}, out{1, Side::outside};
  const auto through = intersect(Box{}, LocalRay{{1, 0, 0}, {-2, 0, 0}}, &in);
  REQUIRE(through);
  REQUIRE(through->enter.t == 0.0);
  REQUIRE(through->exit.t == 1.0);
  REQUIRE(through->exit.face.face == 0);
  REQUIRE_FALSE(intersect(Box{}, LocalRay{{1, 0, 0}, {1, 1, 0}}, &out));
  // A grazing ray in the face's plane leaves through the neighbour, and a direction that rounding
  // has turned outwards does not leave through the face it is on.
  REQUIRE(intersect(Box{}, LocalRay{{1, 0, 0}, {0, 1, 0}}, &in)->exit.face.face == 3);
  REQUIRE(intersect(Box{}, LocalRay{{1, 0, 0}, {1e-17, 1, 0}}, &in)->exit.face.face == 3);
}

TEST_CASE("box: t_error bounds the error of both roots") {
  Random random(7);
  const reference::Solid truth_box = reference::box().solid;
  double worst = 0.0;
  for (int k = 0; k < 50000; ++k) {
    const dvec3 o = random.direction() * std::exp(random.uniform(-2.0, 14.0));
    const dvec3 d = (random.in_cube(1.0) - o) * std::exp(random.uniform(-5, 5));
    const auto ours = line(o, d);
    const auto truth = truth_box.crossings(reference::Vec(o), reference::Vec(d));
    if (truth.size() != 2 || !ours) continue;
    worst = std::max(worst, std::abs(double(ours->enter.t - truth[0].t)) / ours->enter.t_error);
    worst = std::max(worst, std::abs(double(ours->exit.t - truth[1].t)) / ours->exit.t_error);
  }
  CHECK(worst < 1.0);
}

TEST_CASE("box: snapping, nearest face, distance") {
  REQUIRE(snapped(Box{}, {0.9, 0.5, 0.25}, 1) == dvec3(1, 0.5, 0.25));
  REQUIRE(nearest_face(Box{}, {0.1, -0.9, 0.3}, {0.1, -0.2, 0.9}) == 2);
  REQUIRE(nearest_face(Box{}, {0.1, -0.9, 0.3}, {0.1, 0.2, 0.9}) == 5); // it runs into face 2
  REQUIRE(signed_distance(Box{}, {0.1, -0.75, 0.3}) == -0.25);
  REQUIRE(signed_distance(Box{}, {0.1, 0.2, 3.0}) == 2.0);
}
