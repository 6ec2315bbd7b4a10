#include "geometry/world/boundary.h"
#include "tests/catch.h"
#include "tests/geometry/random.h"

#include <algorithm>

using namespace abbe;
using reference::Random;

namespace {

Candidate at(int shape, double t, double t_error, bool entering = true) {
  return {{shape}, {t, t_error, {}, entering}};
}

PlacedShape glass(int medium, int priority = 0) {
  return {Box{}, {}, {100 + medium}, {medium}, priority};
}

Nesting nesting(std::initializer_list<int> ids) {
  Nesting found;
  for (const int id : ids)
    found.push_back({id});
  return found;
}

struct Boundary {
  Hit hit;
  bool visible = false;
};

Boundary resolved(const std::vector<PlacedShape>& shapes, const RayState& state,
                  std::initializer_list<Candidate> candidates) {
  NearestCandidates nearest;
  for (const Candidate& c : candidates)
    nearest.offer(c.shape, c.crossing);
  Boundary boundary;
  boundary.visible = resolve(ShapeTable(shapes), state, nearest.boundary(), boundary.hit);
  return boundary;
}

} // namespace

TEST_CASE("candidates: what rounding cannot tell apart is one boundary, in any order") {
  std::vector<Candidate> all{at(3, 1.0, 1e-9),         at(1, 1.0 + 5e-10, 1e-9),
                             at(2, 1.0 - 5e-10, 1e-9), at(0, 1.0 + 1e-6, 1e-9),
                             at(4, 2.0, 0.1),          at(5, 7.0, 1e-9)};
  Random random(12);
  for (int k = 0; k < 100; ++k) {
    for (std::size_t i = all.size(); i > 1; --i)
      std::swap(all[i - 1], all[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    NearestCandidates nearest;
    for (const Candidate& c : all)
      nearest.offer(c.shape, c.crossing);
    const auto boundary = nearest.boundary();
    REQUIRE(boundary.size() == 3);
    REQUIRE(boundary[0].shape.value == 2);
    REQUIRE(boundary[1].shape.value == 3);
    REQUIRE(boundary[2].shape.value == 1);
    REQUIRE(nearest.reach() == 1.0 - 5e-10 + 1e-9);
  }
}

TEST_CASE("candidates: many offers, far ones first, lose none that belong") {
  // A wide candidate belongs by its error though its t is beyond that of many others.
  Random random(13);
  for (int k = 0; k < 200; ++k) {
    std::vector<Candidate> all{at(0, 1.0, 1e-12), at(1, 1.0, 1e-12), at(2, 1.5, 0.6)};
    for (int i = 3; i < 30; ++i)
      all.push_back(at(i, random.uniform(1.1, 1.4), 1e-12));
    for (std::size_t i = all.size(); i > 1; --i)
      std::swap(all[i - 1], all[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    NearestCandidates nearest;
    for (const Candidate& c : all)
      nearest.offer(c.shape, c.crossing);
    REQUIRE(nearest.boundary().size() == 3);
  }
}

TEST_CASE("medium_of: the highest priority, among equals the last, nothing from opaque solids") {
  std::vector<PlacedShape> shapes{glass(10), glass(11), glass(12, 5), glass(13, -1)};
  shapes.push_back({Box{}, {}, {1}, {}, 99});
  const ShapeTable table(shapes);
  REQUIRE_FALSE(medium_of(table, nesting({})).valid());
  REQUIRE(medium_of(table, nesting({0})).value == 10);
  REQUIRE(medium_of(table, nesting({1, 0})).value == 11);
  REQUIRE(medium_of(table, nesting({2, 1, 0})).value == 12);
  REQUIRE(medium_of(table, nesting({0, 1, 2})).value == 12);
  REQUIRE(medium_of(table, nesting({3})).value == 13);
  REQUIRE(medium_of(table, nesting({3, 0})).value == 10);
  REQUIRE(medium_of(table, nesting({4, 3})).value == 13);
  REQUIRE_FALSE(medium_of(table, nesting({4})).valid());
}

TEST_CASE("resolve: what shows does not depend on rounding") {
  // Glass 0 ends where glass 1 begins; either may come first by a hair.
  const std::vector<PlacedShape> shapes{glass(10), glass(11)};
  RayState state;
  state.ray = {{0, 0, 0}, {0, 0, 1}};
  state.nesting = nesting({0});
  for (const double hair : {-1e-16, 0.0, 1e-16}) {
    const Boundary b =
        resolved(shapes, state, {at(0, 1.0, 1e-15, false), at(1, 1.0 + hair, 1e-15, true)});
    REQUIRE(b.visible);
    REQUIRE(b.hit.shape.value == 1); // defined last, as for medium_of
    REQUIRE(b.hit.material.value == 111);
    REQUIRE(b.hit.entering);
    REQUIRE(b.hit.medium_before.value == 10);
    REQUIRE(b.hit.medium_after.value == 11);
    REQUIRE(b.hit.nesting_after().size() == 1);
    REQUIRE(b.hit.nesting_after()[0].value == 1);
    const Contacts back = b.hit.going_on({}, false).contacts;
    const Contacts through = b.hit.going_on({}, true).contacts;
    REQUIRE(back.size() == 2);
    REQUIRE(through.size() == 2);
    REQUIRE(back[0].shape.value == 1); // the shown surface comes first
    REQUIRE(back[0].side == Side::outside);
    REQUIRE(back[1].side == Side::inside);
    REQUIRE(through[0].side == Side::inside);
    REQUIRE(through[1].side == Side::outside);
  }
}

TEST_CASE("resolve: equal media, higher priorities and opaque surfaces") {
  std::vector<PlacedShape> shapes{glass(10), glass(10), glass(11, 3)};
  shapes.push_back({Square{}, {}, {7}, {}, 0});
  RayState state;
  const auto meet = [&](std::initializer_list<Candidate> candidates) {
    return resolved(shapes, state, candidates);
  };
  state.nesting = nesting({0});
  REQUIRE_FALSE(meet({at(0, 1, 0, false), at(1, 1, 0)}).visible); // the same glass goes on
  REQUIRE_FALSE(meet({at(1, 1, 0)}).visible);
  REQUIRE(meet({at(2, 1, 0)}).visible);
  REQUIRE(meet({at(0, 1, 0, false)}).visible);
  state.nesting = nesting({2});
  REQUIRE_FALSE(meet({at(0, 1, 0)}).visible); // hidden inside a higher priority
  // A square on a glass's face shows, and who goes through it is in the glass.
  state.nesting = nesting({});
  const Boundary b = meet({at(2, 1, 0), at(3, 1, 0)});
  REQUIRE(b.visible);
  REQUIRE(b.hit.shape.value == 3);
  REQUIRE(b.hit.material.value == 7);
  REQUIRE_FALSE(b.hit.medium_before.valid());
  REQUIRE(b.hit.medium_after.value == 11);
  REQUIRE(b.hit.nesting_after()[0].value == 2);
}

TEST_CASE("boundary: a ray along a plane crosses it where it meets what it coincides with") {
  // The root of a plane that the ray runs along may be anywhere; the far face is at 2.
  const std::vector<PlacedShape> shapes{glass(1), {Plane{}, {}, {9}, {}, 0}};
  RayState state{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {}, nesting({0})};
  for (const double root : {0.0, 1.5, 7.0}) {
    const Hit hit = resolved(shapes, state, {at(0, 2.0, 1e-15, false), at(1, root, 10.0)}).hit;
    CHECK(hit.shape == ShapeId{1});
    CHECK(std::abs(hit.t - 2.0) <= 4e-15);
    CHECK(hit.moved);
    CHECK(hit.going_on({}, false).contacts.size() == 2);
  }
  // Roots within each other's bounds stay as they are.
  const Hit close =
      resolved(shapes, state, {at(0, 2.0, 1e-15, false), at(1, 2.0 + 4e-16, 1e-15)}).hit;
  CHECK(close.t == 2.0 + 4e-16);
}
